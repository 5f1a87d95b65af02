using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Rabit.Core.Time;

namespace Rabit.Core.Reactors;

/// <summary>
/// The figures of managers as text: a line each, columns as wide as they need. Times are in milliseconds.
/// </summary>
internal static class ManagerTable
{
    private static readonly string[] Heads =
    [
        "manager", "state", "runs", "merged", "missed", "faults", "restarts", "hangs",
        "work p50", "p99", "p99.9", "max", "wake p50", "p99", "p99.9", "max", "period p50", "p99", "p99.9", "max",
    ];

    // The name and the state; all others are numbers.
    private const int TextColumns = 2;

    public static string Format(IEnumerable<(string Name, string State, ManagerStatus Status)> managers)
    {
        var rows = new List<string[]> { Heads };
        rows.AddRange(managers.Select(m => Cells(m.Name, m.State, m.Status)));
        int[] widths = Heads.Select((_, column) => rows.Max(row => row[column].Length)).ToArray();
        var text = new StringBuilder();
        foreach (string[] row in rows)
        {
            IEnumerable<string> cells = row.Select(
                (cell, column) => column < TextColumns ? cell.PadRight(widths[column]) : cell.PadLeft(widths[column]));
            text.Append(string.Join("  ", cells.ToArray()).TrimEnd()).Append('\n');
        }

        return text.Append("times in ms\n").ToString();
    }

    private static string[] Cells(string name, string state, ManagerStatus status) =>
    [
        name,
        state,
        Number(status.Runs),
        Number(status.WakeUps.Merged),
        Number(status.MissedDeadlines),
        Number(status.Faults),
        Number(status.Restarts),
        Number(status.Hangs),
        .. Times(status.UnitOfWorkTime),
        .. Times(status.WakeLatency),
        .. Times(status.PeriodError),
    ];

    private static string[] Times(DurationStatistics times) => times.Count == 0
        ? ["-", "-", "-", "-"]
        : [Milliseconds(times.Percentile50), Milliseconds(times.Percentile99), Milliseconds(times.Percentile999),
            Milliseconds(times.Max)];

    private static string Milliseconds(TimeSpan time)
        => time.TotalMilliseconds.ToString("0.000", CultureInfo.InvariantCulture);

    private static string Number(long value) => value.ToString(CultureInfo.InvariantCulture);
}
