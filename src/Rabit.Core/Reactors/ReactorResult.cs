using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Diagnostics;
using Rabit.Core.Reactors;

namespace Rabit.Core;

/// <summary>How a run ended. Immutable.</summary>
public sealed class ReactorResult
{
    internal ReactorResult(
        string stopReason, Exception? failure, TimeSpan duration, IReadOnlyList<ManagerResult> managers,
        IReadOnlyList<QueueResult> queues)
    {
        StopReason = stopReason;
        Failure = failure;
        Duration = duration;
        Managers = managers;
        Queues = queues;
    }

    /// <summary>Why it ended, in words.</summary>
    public string StopReason { get; }

    /// <summary>What was wrong with the run itself, for example virtual time that stood still.</summary>
    public Exception? Failure { get; }

    /// <summary>How long it lasted, by the clock of the run.</summary>
    public TimeSpan Duration { get; }

    /// <summary>
    /// How long managers delayed the stop (<see cref="RabitManager.DelaysStop"/>), from the request until it continued;
    /// zero when none did. A part of <see cref="Duration"/>.
    /// </summary>
    public TimeSpan StopDelay { get; internal init; }

    /// <summary>
    /// The managers that still delayed the stop when it continued without them:
    /// <see cref="ReactorOptions.MaxStopDelay"/> was over, or it was requested again. Empty when each had finished, or
    /// none delayed it.
    /// </summary>
    public IReadOnlyList<string> StillDelaying { get; internal init; } = [];

    /// <summary>How each manager ended, in the order of the start.</summary>
    public IReadOnlyList<ManagerResult> Managers { get; }

    /// <summary>
    /// The counters of each queue when all managers had ended; values still resident were never popped.
    /// </summary>
    public IReadOnlyList<QueueResult> Queues { get; }

    /// <summary>
    /// 0; or 1 if a manager faulted or did not stop, the stop did not wait for one that delayed it
    /// (<see cref="StillDelaying"/>), or the run itself failed.
    /// </summary>
    public int ExitCode
        => Failure is null && StillDelaying.Count == 0
            && Managers.All(m => m.Outcome is ManagerOutcome.Ended or ManagerOutcome.NotStarted)
            ? 0 : 1;

    /// <summary>
    /// The figures of all managers as a table of text, one line each: for runtimes and places without a meter.
    /// </summary>
    public string ToTable() => ManagerTable.Format(Managers.Select(m => (m.Name, m.Outcome.ToString(), m.Status)));

    /// <summary>A line for the run, one for each manager, and one for each queue that was not empty.</summary>
    public override string ToString()
        => $"stopped: {OneLine.Of(StopReason)}"
        + (StillDelaying.Count == 0 ? "" : "; did not wait for " + string.Join(", ", StillDelaying.ToArray()))
        + string.Concat(Managers.Select(m => "\n  " + m))
        + string.Concat(Queues.Where(q => q.Counters.Resident > 0).Select(q => "\n  " + q));
}
