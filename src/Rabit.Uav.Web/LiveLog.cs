using System;
using System.Collections.Generic;
using System.Threading;
using Rabit.Core;

namespace Rabit.Uav.Web;

/// <summary>
/// Takes the log of a run to the live page: its last entries wait here until the page takes them, and what has no room
/// is dropped, the oldest first. Any thread; it never waits for more than a copy.
/// </summary>
/// <example>
/// <code>
/// var log = new LiveLog();
/// RabitReactor reactor = uav.CreateReactor(new ReactorOptions { Log = log.Add });
/// </code>
/// </example>
public sealed class LiveLog
{
    private const int MaxWaiting = 200;

    private readonly Lock _gate = new();   // guards all below
    private readonly Queue<LiveLogLine> _waiting = new();
    private long _dropped;

    /// <summary>How many lines the page did not take in time.</summary>
    public long Dropped
    {
        get
        {
            lock (_gate)
                return _dropped;
        }
    }

    /// <summary>Adds an entry of the reactor's log; single units of work are left out.</summary>
    /// <param name="entry">For <see cref="ReactorOptions.Log"/>.</param>
    public void Add(RabitLogEntry entry)
    {
        ArgumentNullException.ThrowIfNull(entry);
        if (entry.Kind != RabitLogKind.Run)
            Add(new LiveLogLine(
                entry.Time, entry.Source, entry.Text, entry.Kind is RabitLogKind.Fault or RabitLogKind.Hang));
    }

    /// <summary>Adds a line of the program's own.</summary>
    /// <param name="time">By the clock of the run.</param>
    /// <param name="source">Who says it.</param>
    /// <param name="text">What it says.</param>
    public void Note(TimeSpan time, string source, string text)
    {
        ArgumentNullException.ThrowIfNull(source);
        ArgumentNullException.ThrowIfNull(text);
        Add(new LiveLogLine(time, source, text, IsFault: false));
    }

    internal bool TryTake(out LiveLogLine line)
    {
        lock (_gate)
            return _waiting.TryDequeue(out line);
    }

    private void Add(LiveLogLine line)
    {
        lock (_gate)
        {
            _waiting.Enqueue(line);
            if (_waiting.Count <= MaxWaiting)
                return;
            _waiting.Dequeue();
            _dropped++;
        }
    }
}
