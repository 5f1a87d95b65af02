using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Preflight;

/// <summary>
/// The parameters of PX4 that decide what it does by itself (PX4 documentation, "Safety", and the list of parameters
/// of version 1.14).
/// </summary>
internal static class Px4Rules
{
    private static readonly Dictionary<int, string> OffboardLossActions = new()
    {
        [0] = "POSCTL",
        [1] = "ALTCTL",
        [2] = "MANUAL",
        [3] = "return",
        [4] = "land",
        [5] = "hold",
        [6] = "terminate",
        [7] = "disarm",
    };

    private static readonly Dictionary<int, string> LossActions = new()
    {
        [0] = "off",
        [1] = "hold",
        [2] = "return",
        [3] = "land",
        [5] = "terminate",
        [6] = "disarm",
    };

    private static readonly Dictionary<int, string> StickInputs = new()
    {
        [0] = "transmitter",
        [1] = "joystick",
        [2] = "both",
        [3] = "the first of both",
        [4] = "none",
    };

    private static readonly Dictionary<int, string> BatteryActions = new()
    {
        [0] = "warning",
        [1] = "return",
        [2] = "land when critical",
        [3] = "return when critical, land when nearly empty",
    };

    private static readonly Dictionary<int, string> FenceActions = new()
    {
        [0] = "none",
        [1] = "warning",
        [2] = "hold",
        [3] = "return",
        [4] = "terminate",
        [5] = "land",
    };

    public static IReadOnlyList<ParameterRule> All { get; } =
    [
        new()
        {
            Name = "COM_OF_LOSS_T", Names = [("COM_OF_LOSS_T", 1)], Wanted = 1,
            Test = ParameterTest.Range(0.5, 5, PreflightResult.Fail, " s"),
            Pass = "0.5 to 5 s", Fail = "all else",
            Reason = "so long after the last set-point of this computer COM_OBL_RC_ACT acts; set-points are sent for 0.5 s "
                + "after the last report, and must not undo it",
        },
        new()
        {
            Name = "COM_OBL_RC_ACT", Names = [("COM_OBL_RC_ACT", 1)], Wanted = 3,
            Test = ParameterTest.Choice(OffboardLossActions, pass: [3, 5], warn: [4]),
            Pass = "return (3) or hold (5)", Warn = "land where it is (4)", Fail = "all else",
            Reason = "what the vehicle does when this computer fails; in POSCTL (0) without a pilot it holds until a "
                + "battery failsafe acts",
        },
        new()
        {
            Name = "COM_RCL_EXCEPT", Names = [("COM_RCL_EXCEPT", 1)], Wanted = 0,
            Test = ParameterTest.Bit(bit: 2, isSet: false, PreflightResult.Warn),
            Pass = "bit 2 not set", Warn = "bit 2 set",
            Reason = "bit 2 switches the failsafe of the transmitter off in OFFBOARD, the mode of the mission",
        },
        new()
        {
            Name = "COM_RC_OVERRIDE", Names = [("COM_RC_OVERRIDE", 1)], Wanted = 2,
            Test = ParameterTest.Bit(bit: 1, isSet: true, PreflightResult.Warn),
            Pass = "bit 1 set", Warn = "bit 1 not set",
            Reason = "only with bit 1 do the pilot's sticks interrupt OFFBOARD, by their speed; the mode switch "
                + "always does",
        },
        new()
        {
            Name = "COM_RC_IN_MODE", Names = [("COM_RC_IN_MODE", 1)],
            Test = ParameterTest.Choice(StickInputs, pass: [0, 1, 2, 3], warn: [4]),
            Pass = "0 to 3", Warn = "none (4)", Fail = "a number that is none of them",
            HowToSet = "set it to 0 for a transmitter",
            Reason = "without sticks no pilot can take over by them",
        },
        new()
        {
            Name = "NAV_RCL_ACT", Names = [("NAV_RCL_ACT", 1)], Wanted = 2,
            Test = ParameterTest.Choice(LossActions, pass: [1, 2], warn: [3]),
            Pass = "hold (1) or return (2)", Warn = "land where it is (3)", Fail = "all else",
            Reason = "the transmitter is lost: the pilot can no longer take over",
        },
        new()
        {
            Name = "NAV_DLL_ACT", Names = [("NAV_DLL_ACT", 1)], Wanted = 2,
            Test = ParameterTest.Choice(LossActions, pass: [1, 2], warn: [0, 3]),
            Pass = "hold (1) or return (2)", Warn = "off (0), land where it is (3)", Fail = "all else",
            Reason = "the ground station is lost; with COM_OBL_RC_ACT the loss of this computer does not depend on it",
        },
        new()
        {
            Name = "COM_LOW_BAT_ACT", Names = [("COM_LOW_BAT_ACT", 1)], Wanted = 3,
            Test = ParameterTest.Choice(BatteryActions, pass: [1, 3], warn: [2]),
            Pass = "return (1, 3)", Warn = "land where it is (2)", Fail = "warning only (0)",
            Reason = "where nothing else acts, the battery brings the vehicle back",
        },
        new()
        {
            Name = "GF_ACTION", Names = [("GF_ACTION", 1)], Wanted = 3,
            Test = ParameterTest.Choice(FenceActions, pass: [2, 3, 5], warn: [0, 1]),
            Pass = "hold (2), return (3), land (5)", Warn = "none (0), warning (1)", Fail = "terminate (4)",
            Reason = "what the autopilot does outside its fence",
        },
    ];
}
