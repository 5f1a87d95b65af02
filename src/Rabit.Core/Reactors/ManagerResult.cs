using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace Rabit.Core;

/// <summary>How one manager ended. Immutable.</summary>
public sealed class ManagerResult
{
    internal ManagerResult(
        string name, ManagerOutcome outcome, long runs, long faultCount, IReadOnlyList<ManagerFault> faults, IReadOnlyList<string> notStopped)
    {
        Name = name;
        Outcome = outcome;
        Runs = runs;
        FaultCount = faultCount;
        Faults = faults;
        NotStopped = notStopped;
    }

    /// <summary>The manager.</summary>
    public string Name { get; }

    /// <summary>How it ended.</summary>
    public ManagerOutcome Outcome { get; }

    /// <summary>How many units of work it ran.</summary>
    public long Runs { get; }

    /// <summary>How many exceptions left its code.</summary>
    public long FaultCount { get; }

    /// <summary>The first of them, ten at most.</summary>
    public IReadOnlyList<ManagerFault> Faults { get; }

    /// <summary>What did not stop in time, the manager or a reader or writer of it, and what it is doing: <c>name: doing</c>.</summary>
    public IReadOnlyList<string> NotStopped { get; }

    /// <summary>What became of the manager's request for real time; empty when it made none.</summary>
    public RealTimeReport RealTime { get; internal set; } = RealTimeReport.Empty;

    /// <summary>One line.</summary>
    public override string ToString()
    {
        string text = string.Format(CultureInfo.InvariantCulture, "{0}: {1}, {2} runs", Name, Outcome, Runs);
        if (FaultCount > 0)
            text += string.Format(CultureInfo.InvariantCulture, ", {0} faults, the first: {1}", FaultCount, Faults[0]);
        return NotStopped.Count == 0 ? text : text + ", did not stop: " + string.Join("; ", NotStopped.ToArray());
    }
}
