using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Rows of the table for one subject, with what they keep between two evaluations.</summary>
internal sealed class HealthRuleSet<T>(HealthRule<T>[] rules)
    where T : struct
{
    private readonly HealthRuleState[] _states = new HealthRuleState[rules.Length];

    /// <summary>Evaluates all rows, and adds what they find.</summary>
    /// <param name="facts">What is judged.</param>
    /// <param name="subject">A manager or a link; null where it is the vehicle.</param>
    /// <param name="options">The thresholds.</param>
    /// <param name="now">The time of the evaluation.</param>
    /// <param name="findings">All that is wrong; none is removed that was there before.</param>
    public void Evaluate(
        in T facts, string? subject, HealthOptions options, TimeSpan now, List<HealthFinding> findings)
    {
        int first = findings.Count;
        for (int i = 0; i < rules.Length; i++)
        {
            HealthRule<T> rule = rules[i];
            bool holds = rule.When(facts, options);
            bool isClear = rule.Until is { } until ? until(facts, options) : !holds;
            _states[i].Update(holds, isClear, now, rule.Dwell(options), rule.ClearDwell(options));
            if (!_states[i].IsFound)
                continue;
            RemoveSuperseded(rule.Supersedes, first, findings);
            findings.Add(new HealthFinding(
                rule.Reason, rule.Level, subject, rule.Figure(facts), rule.Advice, rule.IsAdvisedAfterwards));
        }
    }

    private static void RemoveSuperseded(HealthReasons superseded, int first, List<HealthFinding> findings)
    {
        for (int i = findings.Count - 1; i >= first; i--)
        {
            if ((findings[i].Reason & superseded) != 0)
                findings.RemoveAt(i);
        }
    }
}
