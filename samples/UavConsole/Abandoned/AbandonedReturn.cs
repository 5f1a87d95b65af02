using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>Whether a vehicle that is reported is one that hovers without anyone who commands it.</summary>
internal static class AbandonedReturn
{
    // A vehicle that reports no landed state is taken to fly above this.
    private const double OnGroundHeightMetres = 2;

    /// <summary>Judges a vehicle by reports that were all received in this run.</summary>
    /// <returns>Why it is left alone, as text; null where it is to return.</returns>
    public static string? FindReasonToStay(in VehicleState vehicle)
    {
        if (vehicle.Autopilot == MavAutopilot.Px4)
            return "PX4: its own failsafe has acted";
        if (vehicle.Autopilot != MavAutopilot.Ardupilotmega)
            return $"the autopilot is {vehicle.Autopilot}, not ArduPilot";
        if (!IsCopter(vehicle.VehicleType))
            return $"a {vehicle.VehicleType} is no copter: its modes have other numbers";
        if (!vehicle.IsArmed)
            return "the vehicle is not armed";
        if (vehicle.SystemStatus is MavState.Critical or MavState.Emergency)
            return $"the autopilot is in a failsafe ({vehicle.SystemStatus})";
        if (!string.Equals(vehicle.Mode, "GUIDED", StringComparison.Ordinal))
            return $"its mode is {vehicle.Mode}: another commands it";
        return IsInAir(vehicle) ? null : "the vehicle is not in the air";
    }

    // Copter's number of RTL is another mode of Plane, FBWB.
    private static bool IsCopter(MavType vehicle)
        => vehicle is MavType.Quadrotor or MavType.Coaxial or MavType.Helicopter or MavType.Hexarotor
            or MavType.Octorotor or MavType.Tricopter or MavType.Dodecarotor or MavType.Decarotor
            or MavType.GenericMultirotor;

    private static bool IsInAir(in VehicleState vehicle) => vehicle.LandedState switch
    {
        MavLandedState.InAir or MavLandedState.Takeoff or MavLandedState.Landing => true,
        MavLandedState.OnGround => false,
        _ => vehicle.PositionTime is not null && vehicle.HeightAboveHomeMetres > OnGroundHeightMetres,
    };
}
