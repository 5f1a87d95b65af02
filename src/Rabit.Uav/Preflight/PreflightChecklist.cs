using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Preflight;

/// <summary>Evaluates the rules. One thread.</summary>
internal static class PreflightChecklist
{
    /// <summary>Judges all lines for the autopilot that is connected; no line before there is one.</summary>
    public static PreflightReport Evaluate(PreflightFacts facts)
    {
        if (facts.Vehicle.SystemId == 0)
            return PreflightReport.None;
        MavAutopilot autopilot = facts.Vehicle.Autopilot;
        bool isFixedWing = FixedWings.IsFixedWing(facts.Vehicle.VehicleType);
        bool areParametersRead = facts.Parameters.IsComplete
            || !PreflightRules.ParametersOf(autopilot, isFixedWing).Any();
        return new PreflightReport
        {
            IsComplete = areParametersRead,
            Lines = PreflightRules.Of(autopilot, isFixedWing).Select(r => LineOf(r, facts, areParametersRead))
                .ToImmutableArray(),
            WhenComputerFails = areParametersRead ? ComputerLoss.Describe(facts) : string.Empty,
        };
    }

    private static PreflightLine LineOf(PreflightRule rule, PreflightFacts facts, bool areParametersRead)
    {
        PreflightJudgement found = rule is ParameterRule && !areParametersRead
            ? PreflightJudgement.Unknown("being read")
            : rule.Judge(facts);
        bool isOverridden = found.Result == PreflightResult.Fail
            && facts.Options.Overrides.Contains(rule.Name, StringComparer.Ordinal);
        bool isToBeSet = found.Result is PreflightResult.Warn or PreflightResult.Fail;
        string howToSet = isToBeSet ? rule.HowToSet : string.Empty;
        return new PreflightLine(rule.Name, found.Result, found.Value, howToSet, isOverridden);
    }
}
