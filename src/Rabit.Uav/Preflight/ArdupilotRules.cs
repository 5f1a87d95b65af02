using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Preflight;

/// <summary>
/// The parameters of ArduPilot Copter that decide what it does by itself (ArduPilot documentation, "Failsafe
/// Functions", "Geo-Fencing", and the list of parameters of Copter 4.x).
/// </summary>
internal static class ArdupilotRules
{
    private static readonly Dictionary<int, string> GroundActions = new()
    {
        [0] = "off",
        [1] = "RTL",
        [2] = "continue in AUTO, else RTL",
        [3] = "SmartRTL or RTL",
        [4] = "SmartRTL or land",
        [5] = "land",
        [6] = "AUTO DO_LAND_START or RTL",
        [7] = "BRAKE or land",
    };

    private static readonly Dictionary<int, string> RadioActions = new()
    {
        [0] = "off",
        [1] = "RTL",
        [2] = "continue in AUTO, else RTL",
        [3] = "land",
        [4] = "SmartRTL or RTL",
        [5] = "SmartRTL or land",
        [6] = "AUTO DO_LAND_START or RTL",
        [7] = "BRAKE or land",
    };

    private static readonly Dictionary<int, string> BatteryActions = new()
    {
        [0] = "none",
        [1] = "land",
        [2] = "RTL",
        [3] = "SmartRTL or RTL",
        [4] = "SmartRTL or land",
        [5] = "terminate",
        [6] = "AUTO DO_LAND_START or RTL",
        [7] = "BRAKE or land",
    };

    private static readonly Dictionary<int, string> EstimatorActions = new()
    {
        [0] = "report only",
        [1] = "land",
        [2] = "ALT_HOLD",
        [3] = "land, also from STABILIZE",
    };

    private static readonly Dictionary<int, string> FenceStates = new() { [0] = "off", [1] = "on" };

    private static readonly Dictionary<int, string> FenceActions = new()
    {
        [0] = "report only",
        [1] = "RTL or land",
        [2] = "land",
        [3] = "SmartRTL, RTL or land",
        [4] = "BRAKE or land",
        [5] = "SmartRTL or land",
    };

    public static IReadOnlyList<ParameterRule> All { get; } =
    [
        new()
        {
            Name = "FS_GCS_ENABLE", Names = [("FS_GCS_ENABLE", 1)], Wanted = 1,
            Test = ParameterTest.Choice(GroundActions, pass: [1, 3, 6], warn: [4, 5, 7]),
            Pass = "a return (1, 3, 6)", Warn = "a landing where it is (4, 5, 7)", Fail = "off (0), or goes on (2)",
            Reason = "a ground station whose heartbeats run through this computer is lost with it: the only failsafe "
                + "that acts then; without a ground station it never acts",
        },
        new()
        {
            Name = "FS_GCS_TIMEOUT", Names = [("FS_GCS_TIMEOUT", 1)], Wanted = 5,
            Test = ParameterTest.Range(2, 60, PreflightResult.Warn, " s"),
            Pass = "2 to 60 s", Warn = "all else",
            Reason = "so long the vehicle hovers in GUIDED after the last heartbeat of the ground station",
        },
        new()
        {
            Name = "MAV_GCS_SYSID", Names = [("MAV_GCS_SYSID", 1), ("SYSID_MYGCS", 1)],
            Test = ParameterTest.Custom((value, facts) => value.Equals(facts.Own.SystemId)
                ? PreflightResult.Fail
                : PreflightResult.Pass),
            Pass = "another system id than ours", Fail = "our own system id",
            HowToSet = "set it to the system id of the ground station, 255 as a rule",
            Reason = "only heartbeats of this system id count for FS_GCS_ENABLE: ours must not stand in for those of "
                + "the ground station",
        },
        new()
        {
            Name = "FS_THR_ENABLE", Names = [("FS_THR_ENABLE", 1)], Wanted = 1,
            Test = ParameterTest.Choice(RadioActions, pass: [1, 4, 6], warn: [3, 5, 7]),
            Pass = "a return (1, 4, 6)", Warn = "a landing where it is (3, 5, 7)", Fail = "off (0), or goes on (2)",
            Reason = "the transmitter is lost: the pilot can no longer take over",
        },
        new()
        {
            Name = "FS_EKF_ACTION", Names = [("FS_EKF_ACTION", 1)], Wanted = 1,
            Test = ParameterTest.Choice(EstimatorActions, pass: [1, 3], warn: [2]),
            Pass = "land (1, 3)", Warn = "ALT_HOLD (2): it needs a pilot", Fail = "report only (0)",
            Reason = "without a position it can neither return nor hold",
        },
        new()
        {
            Name = "FS_OPTIONS", Names = [("FS_OPTIONS", 1)], Wanted = 0,
            Test = ParameterTest.Bit(bit: 2, isSet: false, PreflightResult.Warn),
            Pass = "bit 2 not set", Warn = "bit 2 set",
            Reason = "bit 2 switches the failsafe of the transmitter off in GUIDED, the mode of the mission",
        },
        new()
        {
            Name = "BATT_LOW_VOLT", Names = [("BATT_LOW_VOLT", 1)],
            Test = ParameterTest.Custom(JudgeLowVoltage, " V"),
            Pass = "3.3 V for each cell or more, below the present voltage",
            Warn = "less than 3.3 V for each cell: little is left for the return",
            Fail = "0 (off), less than 3 V for each cell, or not below the present voltage",
            HowToSet = "set it to the voltage at which the vehicle must return, 3.5 V for each cell as a rule",
            Reason = "the low-battery failsafe acts by this voltage",
        },
        new()
        {
            Name = "BATT_FS_LOW_ACT", Names = [("BATT_FS_LOW_ACT", 1)], Wanted = 2,
            Test = ParameterTest.Choice(BatteryActions, pass: [2, 3, 6], warn: []),
            Pass = "a return (2, 3, 6)", Fail = "all else",
            Reason = "with a ground station on its own radio, or none, the vehicle hovers in GUIDED after this "
                + "computer has failed until this failsafe acts: then it must return",
        },
        new()
        {
            Name = "BATT_FS_CRT_ACT", Names = [("BATT_FS_CRT_ACT", 1)], Wanted = 1,
            Test = ParameterTest.Choice(BatteryActions, pass: [1, 2, 3, 4, 6, 7], warn: [0]),
            Pass = "land or return (1 to 4, 6, 7)", Warn = "none (0)", Fail = "terminate (5)",
            Reason = "a battery that does not last for the return must land before it is empty",
        },
        new()
        {
            Name = "GUID_TIMEOUT", Names = [("GUID_TIMEOUT", 1)], Wanted = 3, IsOptional = true,
            Test = ParameterTest.Range(0.1, 5, PreflightResult.Warn, " s"),
            Pass = "0.1 to 5 s", Warn = "all else",
            Reason = "so long a velocity is flown on after the last set-point",
        },
        new()
        {
            Name = "FENCE_ENABLE", Names = [("FENCE_ENABLE", 1)],
            Test = ParameterTest.Choice(FenceStates, pass: [1], warn: [0]),
            Pass = "on (1)", Warn = "off (0)", Fail = "a number that is none of them",
            HowToSet = "set it to 1, or give --upload-fence",
            Reason = "the mission's own geofence needs this computer; the autopilot's does not",
        },
        new()
        {
            Name = "FENCE_ACTION", Names = [("FENCE_ACTION", 1)], Wanted = 1,
            Test = ParameterTest.Choice(FenceActions, pass: [1, 2, 3, 4, 5], warn: [0]),
            Pass = "any action (1 to 5)", Warn = "report only (0)", Fail = "a number that is none of them",
            Reason = "what the autopilot does outside its fence",
        },
        new()
        {
            Name = "FENCE_MARGIN", Names = [("FENCE_MARGIN", 1)], Wanted = 2, IsOptional = true,
            Test = ParameterTest.Range(1, 50, PreflightResult.Warn, " m"),
            Pass = "1 to 50 m", Warn = "all else",
            Reason = "how far inside its fence the autopilot turns a flight away",
        },
    ];

    // A pack of which no voltage is reported cannot be compared; its line is "battery".
    // Lithium cells are empty at 3.0 V, and fall from 3.3 V to there within minutes. The number of cells is not known
    // to the autopilot: the least by which the present voltage is none above that of a full cell.
    private static PreflightResult JudgeLowVoltage(double value, PreflightFacts facts)
    {
        const double FullCell = 4.35;
        const double LowCell = 3.3;
        const double EmptyCell = 3.0;
        double volts = facts.Vehicle.BatteryVolts;
        if (!(value > 0) || value >= volts)
            return PreflightResult.Fail;
        if (double.IsNaN(volts))
            return PreflightResult.Warn;
        double cell = Math.Round(value / Math.Ceiling(volts / FullCell), 2);
        return cell < EmptyCell ? PreflightResult.Fail
            : cell < LowCell ? PreflightResult.Warn
            : PreflightResult.Pass;
    }
}
