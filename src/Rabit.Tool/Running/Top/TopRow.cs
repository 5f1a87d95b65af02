using System;
using System.Collections.Generic;

namespace Rabit.Tool.Running.Top;

/// <summary>One manager, queue or message.</summary>
internal sealed record TopRow(string Name, IReadOnlyList<TopCell> Cells)
{
    public double Rate { get; init; }

    public double Load { get; init; }

    public double Trouble { get; init; }

    /// <summary>What comes first is smaller.</summary>
    public int CompareTo(TopRow other, TopOrder order) => order switch
    {
        TopOrder.Name => string.CompareOrdinal(Name, other.Name),
        TopOrder.Rate => other.Rate.CompareTo(Rate),
        TopOrder.Load => other.Load.CompareTo(Load),
        TopOrder.Trouble => other.Trouble.CompareTo(Trouble),
        _ => 0,
    };

    public bool Matches(string filter) => Name.Contains(filter, StringComparison.OrdinalIgnoreCase);
}
