using System;

namespace Rabit.Core.Diagnostics;

/// <summary>Hands entries to the user's log and to the events, on the thread that has something to say. A log that throws harms nobody.</summary>
internal sealed class RabitLog(Action<RabitLogEntry>? sink, bool logRuns, RunClock clock)
{
    /// <summary>Whether the begin of every unit of work is logged.</summary>
    public bool LogsRuns { get; } = logRuns && sink is not null;

    public void Write(RabitLogKind kind, string source, string text, Exception? exception = null)
    {
        if (RabitEventSource.Instance.IsEnabled())
            RabitEventSource.Instance.Entry(kind, source, text);
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
