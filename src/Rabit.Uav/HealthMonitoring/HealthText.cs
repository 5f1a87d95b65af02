using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Findings as text. Called only when they have changed.</summary>
internal static class HealthText
{
    /// <summary>A finding in words; the same on every machine and runtime.</summary>
    public delegate FormattableString Words(HealthFinding finding);

    public static string? Of(IReadOnlyList<HealthFinding> findings)
        => findings.Count == 0
            ? null
            : string.Join("; ", findings.OrderByDescending(f => f.Level).ThenBy(f => f.Reason).Select(Describe));

    /// <summary>One finding as text.</summary>
    public static string Of(in HealthFinding finding) => Describe(finding);

    private static string Describe(HealthFinding finding)
        => HealthRules.WordsOf(finding.Reason) is { } words
            ? FormattableString.Invariant(words(finding))
            : finding.Reason.ToString();
}
