using System;
using Rabit.Core.Time;

namespace Rabit.Core.Diagnostics;

/// <summary>Hands entries to the user's log and to the events, on the thread that writes the entry. Exceptions of the
/// user's log are ignored.</summary>
internal sealed class RabitLog(Action<RabitLogEntry>? sink, bool logRuns, RunClock clock, EventLog? events = null)
{
    /// <summary>Whether the begin of every unit of work is logged.</summary>
    public bool LogsRuns { get; } = logRuns && sink is not null;

    /// <summary>
    /// The event log of a run in virtual time, where one was asked for. It takes every entry but runs, of which it
    /// knows more.
    /// </summary>
    public EventLog? Events { get; } = events;

    public void Write(RabitLogKind kind, string source, string text, Exception? exception = null)
    {
        if (RabitEventSource.Instance.IsEnabled())
            RabitEventSource.Instance.Entry(kind, source, text);
        if (kind != RabitLogKind.Run)
            Events?.Write(source, text);
        if (sink is null)
            return;
        try
        {
            sink(new RabitLogEntry(clock.Now, kind, source, text, exception));
        }
        catch (Exception)
        {
            // There is nowhere left to report it: the log itself is what failed.
        }
    }
}
