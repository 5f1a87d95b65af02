using System.Collections.Generic;
using System.Linq;

namespace Rabit.Tool.Running.Top;

/// <summary>All managers, all queues or all messages.</summary>
internal sealed record TopTable(TopSection Section, IReadOnlyList<TopColumn> Columns, IReadOnlyList<TopRow> Rows)
{
    /// <summary>The rows that are asked for, in the order that is asked for.</summary>
    public IReadOnlyList<TopRow> Select(TopSettings settings)
    {
        IEnumerable<TopRow> rows = Rows.Where(r => r.Matches(settings.Filter));
        Comparer<TopRow> comparer = Comparer<TopRow>.Create((a, b) => a.CompareTo(b, settings.Order));
        rows = settings.Order == TopOrder.Start ? rows : rows.Order(comparer);   // stable
        return (settings.IsReversed ? rows.Reverse() : rows).ToArray();
    }
}
