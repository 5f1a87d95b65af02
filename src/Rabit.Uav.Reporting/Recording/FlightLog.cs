using System.Collections.Generic;
using Rabit.Core;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Keeps the log of a run for the report: the first and the last entries, so that a run of any length fits. Times are
/// those of the run's clock. Any thread.
/// </summary>
/// <example>
/// <code>
/// var log = new FlightLog();
/// RabitReactor reactor = uav.CreateReactor(new ReactorOptions { Log = log.Add });
/// </code>
/// </example>
public sealed class FlightLog
{
    /// <summary>How many of the first, and how many of the last entries are kept.</summary>
    public const int MaxKept = 2_000;

    private readonly object _gate = new();   // guards all below
    private readonly List<FlightEvent> _first = [];
    private readonly Queue<FlightEvent> _last = new();
    private long _count;

    /// <summary>How many entries were added; those that are not kept included.</summary>
    public long Count
    {
        get
        {
            lock (_gate)
                return _count;
        }
    }

    /// <summary>
    /// Adds an entry: for <see cref="ReactorOptions.Log"/>. Entries of kind <see cref="RabitLogKind.Run"/> are
    /// ignored.
    /// </summary>
    /// <param name="entry">The entry.</param>
    public void Add(RabitLogEntry entry)
    {
        if (entry.Kind == RabitLogKind.Run)
            return;
        lock (_gate)
        {
            _count++;
            Keep(new FlightEvent(entry.Time, entry.Kind, entry.Source, entry.Text));
        }
    }

    /// <summary>Returns a copy of the entries that are kept, oldest first.</summary>
    public IReadOnlyList<FlightEvent> ToArray()
    {
        lock (_gate)
            return [.. _first, .. _last];
    }

    private void Keep(FlightEvent e)
    {
        if (_first.Count < MaxKept)
        {
            _first.Add(e);
            return;
        }

        _last.Enqueue(e);
        if (_last.Count > MaxKept)
            _last.Dequeue();
    }
}
