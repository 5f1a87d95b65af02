using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Flight modes of ArduPilot by the names that its users know from their ground stations. The custom mode of a
/// heartbeat is a plain number whose meaning depends on the kind of vehicle (enums COPTER_MODE, PLANE_MODE, ... of
/// ardupilotmega.xml).
/// </summary>
internal static class ArdupilotModes
{
    // No kind of vehicle has a mode above.
    private const uint MaxMode = 63;

    /// <summary>Whether it flies as a copter does.</summary>
    public static bool IsCopter(MavType vehicle)
        => vehicle is MavType.Quadrotor or MavType.Coaxial or MavType.Helicopter or MavType.Hexarotor
            or MavType.Octorotor or MavType.Tricopter or MavType.Dodecarotor or MavType.Decarotor
            or MavType.GenericMultirotor;

    /// <summary>The number of a mode, by its name in any case; null where the vehicle has none of that name.</summary>
    public static uint? NumberOf(MavType vehicle, string name)
    {
        for (uint mode = 0; mode <= MaxMode; mode++)
        {
            if (string.Equals(NameOf(vehicle, mode), name, StringComparison.OrdinalIgnoreCase))
                return mode;
        }

        return null;
    }

    /// <summary>The name; null for a number or a vehicle that is not known here.</summary>
    public static string? NameOf(MavType vehicle, uint customMode) => vehicle switch
    {
        _ when IsCopter(vehicle) => Copter((CopterMode)customMode),
        MavType.FixedWing or MavType.VtolTailsitterDuorotor or MavType.VtolTailsitterQuadrotor or MavType.VtolTiltrotor
            or MavType.VtolFixedrotor or MavType.VtolTailsitter or MavType.VtolTiltwing or MavType.VtolReserved5
            => Plane((PlaneMode)customMode),
        MavType.GroundRover or MavType.SurfaceBoat => Rover((RoverMode)customMode),
        MavType.Submarine => Sub((SubMode)customMode),
        MavType.AntennaTracker => Tracker((TrackerMode)customMode),
        MavType.Airship => Blimp(customMode),
        _ => null,
    };

    private static string? Copter(CopterMode mode) => mode switch
    {
        CopterMode.Stabilize => "STABILIZE",
        CopterMode.Acro => "ACRO",
        CopterMode.AltHold => "ALT_HOLD",
        CopterMode.Auto => "AUTO",
        CopterMode.Guided => "GUIDED",
        CopterMode.Loiter => "LOITER",
        CopterMode.Rtl => "RTL",
        CopterMode.Circle => "CIRCLE",
        CopterMode.Land => "LAND",
        CopterMode.Drift => "DRIFT",
        CopterMode.Sport => "SPORT",
        CopterMode.Flip => "FLIP",
        CopterMode.Autotune => "AUTOTUNE",
        CopterMode.Poshold => "POSHOLD",
        CopterMode.Brake => "BRAKE",
        CopterMode.Throw => "THROW",
        CopterMode.AvoidAdsb => "AVOID_ADSB",
        CopterMode.GuidedNogps => "GUIDED_NOGPS",
        CopterMode.SmartRtl => "SMART_RTL",
        CopterMode.Flowhold => "FLOWHOLD",
        CopterMode.Follow => "FOLLOW",
        CopterMode.Zigzag => "ZIGZAG",
        CopterMode.Systemid => "SYSTEMID",
        CopterMode.Autorotate => "AUTOROTATE",
        CopterMode.AutoRtl => "AUTO_RTL",
        CopterMode.Turtle => "TURTLE",
        _ => null,
    };

    private static string? Plane(PlaneMode mode) => mode switch
    {
        PlaneMode.Manual => "MANUAL",
        PlaneMode.Circle => "CIRCLE",
        PlaneMode.Stabilize => "STABILIZE",
        PlaneMode.Training => "TRAINING",
        PlaneMode.Acro => "ACRO",
        PlaneMode.FlyByWireA => "FBWA",
        PlaneMode.FlyByWireB => "FBWB",
        PlaneMode.Cruise => "CRUISE",
        PlaneMode.Autotune => "AUTOTUNE",
        PlaneMode.Auto => "AUTO",
        PlaneMode.Rtl => "RTL",
        PlaneMode.Loiter => "LOITER",
        PlaneMode.Takeoff => "TAKEOFF",
        PlaneMode.AvoidAdsb => "AVOID_ADSB",
        PlaneMode.Guided => "GUIDED",
        PlaneMode.Initializing => "INITIALISING",
        PlaneMode.Qstabilize => "QSTABILIZE",
        PlaneMode.Qhover => "QHOVER",
        PlaneMode.Qloiter => "QLOITER",
        PlaneMode.Qland => "QLAND",
        PlaneMode.Qrtl => "QRTL",
        PlaneMode.Qautotune => "QAUTOTUNE",
        PlaneMode.Qacro => "QACRO",
        PlaneMode.Thermal => "THERMAL",
        PlaneMode.LoiterAltQland => "LOITERALTQLAND",
        PlaneMode.Autoland => "AUTOLAND",
        _ => null,
    };

    private static string? Rover(RoverMode mode) => mode switch
    {
        RoverMode.Manual => "MANUAL",
        RoverMode.Acro => "ACRO",
        RoverMode.Steering => "STEERING",
        RoverMode.Hold => "HOLD",
        RoverMode.Loiter => "LOITER",
        RoverMode.Follow => "FOLLOW",
        RoverMode.Simple => "SIMPLE",
        RoverMode.Dock => "DOCK",
        RoverMode.Circle => "CIRCLE",
        RoverMode.Auto => "AUTO",
        RoverMode.Rtl => "RTL",
        RoverMode.SmartRtl => "SMART_RTL",
        RoverMode.Guided => "GUIDED",
        RoverMode.Initializing => "INITIALISING",
        _ => null,
    };

    private static string? Sub(SubMode mode) => mode switch
    {
        SubMode.Stabilize => "STABILIZE",
        SubMode.Acro => "ACRO",
        SubMode.AltHold => "ALT_HOLD",
        SubMode.Auto => "AUTO",
        SubMode.Guided => "GUIDED",
        SubMode.Circle => "CIRCLE",
        SubMode.Surface => "SURFACE",
        SubMode.Poshold => "POSHOLD",
        SubMode.Manual => "MANUAL",
        SubMode.Motordetect => "MOTORDETECT",
        SubMode.Surftrak => "SURFTRAK",
        _ => null,
    };

    private static string? Tracker(TrackerMode mode) => mode switch
    {
        TrackerMode.Manual => "MANUAL",
        TrackerMode.Stop => "STOP",
        TrackerMode.Scan => "SCAN",
        TrackerMode.ServoTest => "SERVO_TEST",
        TrackerMode.Guided => "GUIDED",
        TrackerMode.Auto => "AUTO",
        TrackerMode.Initializing => "INITIALISING",
        _ => null,
    };

    // ArduPilot, Blimp/mode.h; the dialects have no enum for it.
    private static string? Blimp(uint mode) => mode switch
    {
        0 => "LAND",
        1 => "MANUAL",
        2 => "VELOCITY",
        3 => "LOITER",
        4 => "RTL",
        _ => null,
    };
}
