using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

namespace Rabit.Core;

/// <summary>What became of a <see cref="RealTimeRequest"/>: asked, granted, why not. Immutable.</summary>
public sealed class RealTimeReport
{
    internal RealTimeReport(IReadOnlyList<RealTimeGrant> grants) => Grants = grants;

    /// <summary>Nothing was asked for, or it is not time yet.</summary>
    public static RealTimeReport Empty { get; } = new([]);

    /// <summary>What was asked for, part by part.</summary>
    public IReadOnlyList<RealTimeGrant> Grants { get; }

    /// <summary>Whether everything that was asked for was granted.</summary>
    public bool IsGranted => Grants.All(g => g.IsGranted);

    /// <summary>The table as text, a line for each part; empty when nothing was asked for.</summary>
    public override string ToString()
    {
        if (Grants.Count == 0)
            return string.Empty;
        int width = Math.Max(5, Grants.Max(g => g.Asked.Length)) + 2;
        StringBuilder text = new StringBuilder("asked".PadRight(width)).Append("granted  why not");
        foreach (RealTimeGrant grant in Grants)
            text.Append('\n').Append(grant.Asked.PadRight(width)).Append(grant.IsGranted ? "yes" : "no       " + grant.WhyNot);
        return text.ToString();
    }
}
