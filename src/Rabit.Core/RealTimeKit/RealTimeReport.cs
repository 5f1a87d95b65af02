using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace Rabit.Core;

/// <summary>The outcome of a <see cref="RealTimeRequest"/>: requested, granted, reason. Immutable.</summary>
public sealed class RealTimeReport
{
    private const string Head = "requested";

    internal RealTimeReport(IReadOnlyList<RealTimeGrant> grants) => Grants = grants;

    /// <summary>Nothing was requested, or nothing yet.</summary>
    public static RealTimeReport Empty { get; } = new([]);

    /// <summary>What was requested, part by part.</summary>
    public IReadOnlyList<RealTimeGrant> Grants { get; }

    /// <summary>Whether everything that was requested was granted.</summary>
    public bool IsGranted => Grants.All(g => g.IsGranted);

    /// <summary>The table as text, a line for each part; empty when nothing was requested.</summary>
    public override string ToString()
    {
        if (Grants.Count == 0)
            return string.Empty;
        int width = Math.Max(Head.Length, Grants.Max(g => g.Requested.Length)) + 2;
        StringBuilder text = new StringBuilder(Head.PadRight(width)).Append("granted  reason");
        foreach (RealTimeGrant grant in Grants)
            text.Append('\n').Append(grant.Requested.PadRight(width))
                .Append(grant.IsGranted ? "yes" : "no       " + grant.Reason);
        return text.ToString();
    }
}
