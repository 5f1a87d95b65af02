using System;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Preflight;

/// <summary>
/// What the vehicle does when this computer fails in flight, by its parameters: then only the autopilot can act.
/// </summary>
internal static class ComputerLoss
{
    /// <returns>One sentence for each way in which the ground station is connected; empty for other makes.</returns>
    public static string Describe(PreflightFacts facts) => facts.Vehicle.Autopilot switch
    {
        _ when FixedWings.IsFixedWing(facts.Vehicle.VehicleType)
            => "it flies on to the place of its leg and circles there, until its pilot or a failsafe of its own acts, "
                + "however the ground station is connected",
        MavAutopilot.Ardupilotmega => OfArdupilot(facts),
        MavAutopilot.Px4 => OfPx4(facts),
        _ => string.Empty,
    };

    private static string OfArdupilot(PreflightFacts facts)
    {
        string battery = $"it hovers in GUIDED until BATT_FS_LOW_ACT {ValueOf(facts, "BATT_FS_LOW_ACT")} acts";
        string ground = IsOn(facts, "FS_GCS_ENABLE")
            ? $"FS_GCS_ENABLE {ValueOf(facts, "FS_GCS_ENABLE")} acts {ValueOf(facts, "FS_GCS_TIMEOUT")} after its last "
                + "heartbeat"
            : battery + ", since FS_GCS_ENABLE is off or unknown";
        return $"with a ground station whose heartbeats run through this computer {ground}; with a ground station on "
            + $"its own radio, or none, {battery}";
    }

    private static string OfPx4(PreflightFacts facts)
        => $"COM_OBL_RC_ACT {ValueOf(facts, "COM_OBL_RC_ACT")} acts {ValueOf(facts, "COM_OF_LOSS_T")} after the last "
            + "set-point, however the ground station is connected";

    private static bool IsOn(PreflightFacts facts, string name)
        => RuleOf(facts, name) is { } rule && rule.TryRead(facts.Parameters, out _, out double value) && value > 0;

    private static string ValueOf(PreflightFacts facts, string name)
        => RuleOf(facts, name) is { } rule && rule.TryRead(facts.Parameters, out _, out double value)
            ? rule.Test.ValueText(value) + rule.Test.Meaning(value)
            : "(unknown)";

    private static ParameterRule? RuleOf(PreflightFacts facts, string name)
        => PreflightRules.ParametersOf(facts.Vehicle.Autopilot)
            .FirstOrDefault(r => string.Equals(r.Name, name, StringComparison.Ordinal));
}
