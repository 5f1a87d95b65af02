using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace Rabit.Core;

/// <summary>How one manager ended. Immutable.</summary>
public sealed class ManagerResult
{
    internal ManagerResult(string name, ManagerOutcome outcome)
    {
        Name = name;
        Outcome = outcome;
    }

    /// <summary>The manager.</summary>
    public string Name { get; }

    /// <summary>How it ended.</summary>
    public ManagerOutcome Outcome { get; }

    /// <summary>How many units of work it ran.</summary>
    public long Runs { get; internal init; }

    /// <summary>How many times it was started up again after a fault.</summary>
    public long Restarts { get; internal init; }

    /// <summary>How many exceptions left its code.</summary>
    public long FaultCount { get; internal init; }

    /// <summary>The first of them, ten at most.</summary>
    public IReadOnlyList<ManagerFault> Faults { get; internal init; } = [];

    /// <summary>How many times the watchdog found it hanging.</summary>
    public long HangCount { get; internal init; }

    /// <summary>The first of them, ten at most.</summary>
    public IReadOnlyList<ManagerHang> Hangs { get; internal init; } = [];

    /// <summary>
    /// What did not stop in time, the manager or a reader or writer of it, and what it is doing: <c>name: doing</c>.
    /// </summary>
    public IReadOnlyList<string> NotStopped { get; internal init; } = [];

    /// <summary>The last status it posted, or the watchdog for it.</summary>
    public ManagerStatus Status { get; internal init; }

    /// <summary>What became of the manager's request for real time; empty when it made none.</summary>
    public RealTimeReport RealTime { get; internal init; } = RealTimeReport.Empty;

    /// <summary>One line.</summary>
    public override string ToString()
    {
        string text = string.Format(CultureInfo.InvariantCulture, "{0}: {1}, {2} runs", Name, Outcome, Runs);
        if (Restarts > 0)
            text += string.Format(CultureInfo.InvariantCulture, ", {0} restarts", Restarts);
        if (FaultCount > 0)
            text += string.Format(CultureInfo.InvariantCulture, ", {0} faults, the first: {1}", FaultCount, Faults[0]);
        if (HangCount > 0)
            text += string.Format(CultureInfo.InvariantCulture, ", {0} hangs, the first: {1}", HangCount, Hangs[0]);
        return NotStopped.Count == 0 ? text : text + ", did not stop: " + string.Join("; ", NotStopped.ToArray());
    }
}
