using System;
using System.Threading;
using Rabit.Core.Time;

namespace Rabit.Core.Diagnostics;

/// <summary>
/// Hands entries to the user's log and to the events, on the thread that writes the entry. Faults and hangs that no log
/// takes, because there is none or because it throws, go to standard error.
/// </summary>
internal sealed class RabitLog(
    Action<RabitLogEntry>? sink, bool logRuns, RunClock clock, EventLog? events = null,
    StandardErrorLog? standardError = null)
{
    /// <summary>Whether the begin of every unit of work is logged.</summary>
    public bool LogsRuns { get; } = logRuns && sink is not null;

    /// <summary>
    /// The event log of a run in virtual time, where one was asked for. It takes every entry but runs, of which it
    /// knows more.
    /// </summary>
    public EventLog? Events { get; } = events;

    /// <summary>Never throws.</summary>
    public void Write(RabitLogKind kind, string source, string text, Exception? exception = null)
    {
        if (RabitEventSource.Instance.IsEnabled())
            RabitEventSource.Instance.Entry(kind, source, text);
        if (kind != RabitLogKind.Run)
            Events?.Write(source, text);
        if (sink is null && !StandardErrorLog.Takes(kind))
            return;

        RabitLogEntry entry = new(clock.NowOr(TimeSpan.Zero), kind, source, text, exception);
        if (TryHandOver(entry) || standardError is null || !StandardErrorLog.Takes(kind))
            return;
        try
        {
            standardError.Write(entry);
        }
        catch (Exception)
        {
            // There is nowhere left to report it.
        }
    }

    /// <summary>The run is over.</summary>
    public void Close()
    {
        Events?.Close();
        standardError?.Close();
    }

    private bool TryHandOver(RabitLogEntry entry)
    {
        if (sink is null)
            return false;
        try
        {
            try
            {
                sink(entry);
            }
            catch (ThreadInterruptedException)
            {
                // An exception whose members interrupt the thread leaves that for the next wait, which may be one for
                // a lock of the log. It is over when it has been thrown, and no reason to lose the fault.
                sink(entry);
            }

            return true;
        }
        catch (Exception)
        {
            // The user's log is what failed.
            return false;
        }
    }
}
