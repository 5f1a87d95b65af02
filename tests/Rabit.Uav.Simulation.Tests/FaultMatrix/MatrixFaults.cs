using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation.Tests.FaultMatrix;

/// <summary>What goes wrong in the fault matrix.</summary>
internal static class MatrixFaults
{
    // Inside our own fence, beside the area, so that it is the target that is noticed and not the place.
    private static readonly NedPosition Elsewhere = new(20, 0, -25);

    public static readonly MatrixFault PilotHold = MatrixFault.Pilot(
        "pilot: LOITER by switch / AUTO.LOITER", "LOITER", "AUTO.LOITER", bySwitch: true);

    public static readonly MatrixFault PilotPosition = MatrixFault.Pilot(
        "pilot: BRAKE / POSCTL by command", "BRAKE", "POSCTL");

    public static readonly MatrixFault PilotReturn = MatrixFault.Pilot("pilot: RTL / AUTO.RTL", "RTL", "AUTO.RTL");

    public static readonly MatrixFault PilotLand = MatrixFault.Pilot("pilot: LAND / AUTO.LAND", "LAND", "AUTO.LAND");

    public static readonly MatrixFault OtherReposition = Other("other commander: one DO_REPOSITION", seconds: 0);

    public static readonly MatrixFault OtherTargets = Other("other commander: targets at 10 Hz for 60 s", seconds: 60);

    public static readonly MatrixFault GroundStationLost = MatrixFault.Of(
        "ground station lost", ScriptedFaultKind.GroundStationSilent);

    public static readonly MatrixFault RcLost = MatrixFault.Of("remote control lost", ScriptedFaultKind.RcLost);

    public static readonly MatrixFault BatteryLow = MatrixFault.Of(
        "battery at 20 %", ScriptedFaultKind.BatteryTo, 0.20);

    public static readonly MatrixFault BatteryCritical = MatrixFault.Of(
        "battery at 8 %", ScriptedFaultKind.BatteryTo, 0.08);

    public static readonly MatrixFault BatteryAged = MatrixFault.Of(
        "battery truly at 15 %, reported as before", ScriptedFaultKind.BatteryTrueTo, 0.15);

    public static readonly MatrixFault BatteryBelowCritical = MatrixFault.Of(
        "battery at 5.5 %, below the autopilot's critical level", ScriptedFaultKind.BatteryTo, 0.055);

    public static readonly MatrixFault VoltageLow = MatrixFault.Of(
        "battery voltage low", ScriptedFaultKind.BatteryVolts, 9.8);

    public static readonly MatrixFault VoltageCritical = MatrixFault.Of(
        "battery voltage critical", ScriptedFaultKind.BatteryVolts, 9.4);

    public static readonly MatrixFault BatteryUnknown = MatrixFault.Outside(
        "no battery messages any more", flight => flight.Tap.HidesBattery = true);

    public static readonly MatrixFault GpsGlitch = MatrixFault.Of(
        "GPS glitch of 50 m for 10 s", ScriptedFaultKind.GpsGlitch, 50, 10);

    public static readonly MatrixFault GpsLostShort = MatrixFault.Of(
        "GPS lost for 3 s", ScriptedFaultKind.GpsLost, seconds: 3);

    public static readonly MatrixFault GpsLost = MatrixFault.Of("GPS lost", ScriptedFaultKind.GpsLost);

    public static readonly MatrixFault Estimator = MatrixFault.Of(
        "estimator variances too large", ScriptedFaultKind.EkfFailsafe);

    public static readonly MatrixFault FixNotReportedShort = MatrixFault.Of(
        "no fix reported for 10 s, position good", ScriptedFaultKind.FixNotReported, seconds: 10);

    public static readonly MatrixFault FixNotReported = MatrixFault.Of(
        "no fix reported, position good", ScriptedFaultKind.FixNotReported);

    public static readonly MatrixFault PositionZeroShort = MatrixFault.Of(
        "positions of 0/0 for 5 s", ScriptedFaultKind.PositionZero, seconds: 5);

    public static readonly MatrixFault PositionFrozenShort = MatrixFault.Of(
        "position frozen for 6 s", ScriptedFaultKind.PositionFrozen, seconds: 6);

    public static readonly MatrixFault PositionFrozen = MatrixFault.Of(
        "position frozen", ScriptedFaultKind.PositionFrozen);

    public static readonly MatrixFault PositionJump = MatrixFault.Of(
        "position jumps by 15 m for 6 s", ScriptedFaultKind.PositionJump, 15, 6);

    public static readonly MatrixFault EstimatorRatioShort = MatrixFault.Of(
        "estimator off its measurements for 10 s", ScriptedFaultKind.EstimatorRatio, 1.2, 10);

    public static readonly MatrixFault EstimatorRatio = MatrixFault.Of(
        "estimator off its measurements", ScriptedFaultKind.EstimatorRatio, 1.2);

    public static readonly MatrixFault ChargeUnknown = MatrixFault.Of(
        "charge of the battery unknown (-1)", ScriptedFaultKind.BatteryUnknown);

    public static readonly MatrixFault CellVoltageLow = MatrixFault.Of(
        "3.43 V a cell with a good count, above the autopilot's limit", ScriptedFaultKind.BatteryVolts, 10.3);

    public static readonly MatrixFault Fence = MatrixFault.Outside(
        "fence breached: its height set to 2 m by the ground station", SetFence);

    public static readonly MatrixFault Reboot =
        MatrixFault.Of("autopilot reboots, stays armed", ScriptedFaultKind.Reboot);

    public static readonly MatrixFault RebootDisarmed = MatrixFault.Of(
        "autopilot reboots, motors stop", ScriptedFaultKind.Reboot, 1);

    public static readonly MatrixFault Silent3 = MatrixFault.Of(
        "link silent 3 s", ScriptedFaultKind.LinkSilent, seconds: 3);

    public static readonly MatrixFault Silent20 = MatrixFault.Of(
        "link silent 20 s", ScriptedFaultKind.LinkSilent, seconds: 20);

    public static readonly MatrixFault Silent400 = MatrixFault.Of(
        "link silent 400 s", ScriptedFaultKind.LinkSilent, seconds: 400);

    public static readonly MatrixFault MissionControlHangs = MatrixFault.Hang("mission control");

    public static readonly MatrixFault HealthHangs = MatrixFault.Hang("health");

    public static readonly MatrixFault AutopilotInterfaceHangs = MatrixFault.Hang("autopilot");

    public static readonly MatrixFault ImageProcessingHangs = MatrixFault.Hang("image processing");

    public static readonly MatrixFault SensorFusionHangs = MatrixFault.Hang("sensor fusion");

    public static readonly MatrixFault CommunicationsHangs = MatrixFault.Hang("communications");

    public static readonly MatrixFault CameraSilent = MatrixFault.Of(
        "camera silent", ScriptedFaultKind.CameraFreeze, seconds: 1000);

    public static readonly MatrixFault PicturesBlack = Pictures("pictures black", ScriptedFaultKind.PicturesBlack);

    public static readonly MatrixFault PicturesBlackShort = MatrixFault.Of(
        "pictures black for 10 s", ScriptedFaultKind.PicturesBlack, seconds: 10);

    public static readonly MatrixFault PicturesWhite = Pictures("pictures white", ScriptedFaultKind.PicturesWhite);

    public static readonly MatrixFault PicturesFrozen = Pictures("pictures frozen", ScriptedFaultKind.PicturesFrozen);

    public static readonly MatrixFault PicturesDefocused = Pictures(
        "pictures defocused", ScriptedFaultKind.PicturesDefocused);

    public static readonly MatrixFault PicturesCovered = Pictures(
        "half of the pictures covered", ScriptedFaultKind.PicturesCovered);

    public static readonly MatrixFault PicturesMotionBlurred = Pictures(
        "pictures motion-blurred", ScriptedFaultKind.PicturesMotionBlurred);

    public static readonly MatrixFault PictureNumbersRepeat = Pictures(
        "picture numbers repeat", ScriptedFaultKind.PictureNumbersRepeat);

    public static readonly MatrixFault PictureTimesOff = Pictures(
        "camera clock 60 s late", ScriptedFaultKind.PictureTimesOff, 60);

    public static readonly MatrixFault CameraClockLate = MatrixFault.Of(
        "camera clock 0.5 s late", ScriptedFaultKind.PictureTimesOff, 0.5);

    public static readonly MatrixFault CameraClockEarly = MatrixFault.Of(
        "camera clock 0.5 s early", ScriptedFaultKind.PictureTimesOff, -0.5);

    public static readonly MatrixFault CameraClockLittle = MatrixFault.Of(
        "camera clock 0.1 s late", ScriptedFaultKind.PictureTimesOff, 0.1);

    public static readonly MatrixFault TimesyncWrong = MatrixFault.Of(
        "one answer to TIMESYNC wrong by 5 s", ScriptedFaultKind.TimesyncWrong, 5);

    public static readonly MatrixFault LinkDelayed = MatrixFault.Of(
        "telemetry 0.1 s later than before", ScriptedFaultKind.LinkDelayed, 0.1);

    public static readonly MatrixFault AttitudeSilent = Pictures(
        "no attitude any more", ScriptedFaultKind.AttitudeSilent);

    public static readonly MatrixFault WindHigh = MatrixFault.Of("wind of 15 m/s", ScriptedFaultKind.WindTo, 15);

    public static readonly MatrixFault Gust = MatrixFault.Of(
        "a gust of 20 m/s for 6 s", ScriptedFaultKind.Gust, 20, 6);

    public static readonly MatrixFault ComputerTooHot = MatrixFault.Of(
        "computer at 90 degrees", ScriptedFaultKind.ComputerHot, 90);

    public static readonly MatrixFault ComputerWarm = MatrixFault.Of(
        "computer at 78 degrees", ScriptedFaultKind.ComputerHot, 78);

    public static readonly MatrixFault UnderVoltage = MatrixFault.Of(
        "computer with too little voltage", ScriptedFaultKind.ComputerUnderVoltage);

    public static readonly MatrixFault DiskLow = MatrixFault.Of(
        "disk with 100 MB free", ScriptedFaultKind.DiskLow, 100e6);

    // The autopilot still receives it: its own failsafe does not act.
    public static readonly MatrixFault GroundStationHidden = MatrixFault.Outside(
        "ground station not received by the computer",
        flight => flight.Tap.HidesGroundStationUntil = TimeSpan.MaxValue);

    public static readonly MatrixFault GroundStationHidden20 = MatrixFault.Outside(
        "ground station not received by the computer for 20 s",
        flight => flight.Tap.HidesGroundStationUntil = flight.Flight.Reactor.Now + TimeSpan.FromSeconds(20));

    public static readonly MatrixFault ManagerThrows = MatrixFault.Outside("a manager of the user throws", null)
        with
    { Throws = true };

    public static readonly MatrixFault Stop = MatrixFault.Outside("Ctrl-C", null) with { StopsProgram = true };

    private static MatrixFault Pictures(string name, ScriptedFaultKind kind, double value = 0)
        => MatrixFault.Of(name, kind, value);

    private static MatrixFault Other(string name, double seconds) => new(name, (_, at) =>
    [
        new ScriptedFault
        {
            Kind = ScriptedFaultKind.OtherCommander, At = at, Place = Elsewhere,
            Duration = TimeSpan.FromSeconds(seconds),
        },
    ]);

    // Both names: an autopilot ignores one that it does not have.
    private static void SetFence(MatrixFlight flight)
    {
        foreach (string name in new[] { "FENCE_ALT_MAX", "GF_MAX_VER_DIST" })
        {
            flight.Tap.SendAsGroundStation(new ParamSet
            {
                TargetSystem = 1,
                TargetComponent = 1,
                ParamId = new Text16(name),
                ParamValue = 2,
                ParamType = MavParamType.Real32,
            });
        }
    }
}
