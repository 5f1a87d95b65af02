using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Preflight;

/// <summary>All rules of the pre-flight checklist, in the order of its lines. Immutable; any thread.</summary>
public static class PreflightRules
{
    private static readonly Lazy<IReadOnlyList<PreflightRule>> AllRules = new(
        () =>
        [
            .. VehicleRules.All,
            .. For(MavAutopilot.Ardupilotmega, false, ReturnHeightRule.Ardupilot, ArdupilotRules.All),
            VehicleRules.OfArdupilotPlane,
            .. For(MavAutopilot.Px4, null, ReturnHeightRule.Px4, Px4Rules.All),
        ]);

    /// <summary>The rules, as documentation and help show them.</summary>
    public static IReadOnlyList<PreflightRuleInfo> All { get; } = [.. AllRules.Value.Select(Describe)];

    /// <summary>The names of the lines, each once.</summary>
    public static IReadOnlyList<string> Names { get; } =
        [.. AllRules.Value.Select(r => r.Name).Distinct(StringComparer.Ordinal)];

    internal static IEnumerable<PreflightRule> Of(MavAutopilot autopilot, bool isFixedWing = false)
        => AllRules.Value.Where(r => r.IsFor(autopilot, isFixedWing));

    internal static IEnumerable<ParameterRule> ParametersOf(MavAutopilot autopilot, bool isFixedWing = false)
        => Of(autopilot, isFixedWing).OfType<ParameterRule>();

    private static IEnumerable<PreflightRule> For(
        MavAutopilot autopilot, bool? isOfFixedWing, IReadOnlyList<(string Name, double Scale)> returnHeight,
        IReadOnlyList<ParameterRule> rules)
        => new[] { ReturnHeightRule.Create(returnHeight) }.Concat(rules)
            .Select(r => r.For(autopilot, isOfFixedWing));

    private static PreflightRuleInfo Describe(PreflightRule rule)
    {
        string set = rule is ParameterRule { Wanted: { } wanted } parameter
            ? parameter.Test.WantedText(wanted)
            : string.Empty;
        return new PreflightRuleInfo(
            rule.Name, rule.Autopilot, rule.Pass, rule.Warn, rule.Fail, set, rule.Reason);
    }
}
