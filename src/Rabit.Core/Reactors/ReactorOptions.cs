using System;
using System.Collections.Generic;

namespace Rabit.Core;

/// <summary>How a reactor runs. Read once, when the reactor is made.</summary>
public sealed class ReactorOptions
{
    /// <summary>Real or virtual time.</summary>
    /// <value>The default is <see cref="RealTime"/>.</value>
    public RabitTime Time { get; set; } = new RealTime();

    /// <summary>
    /// Where the log goes; called on the thread that writes the entry, so it must be thread-safe. An exception that it
    /// throws is ignored.
    /// </summary>
    /// <value>The default is none; faults are in the result all the same.</value>
    public Action<RabitLogEntry>? Log { get; set; }

    /// <summary>Whether every unit of work is logged too, with its wake-up causes.</summary>
    /// <value>The default is false.</value>
    public bool LogRuns { get; set; }

    /// <summary>What the outside knows the run by: a tag of its meter.</summary>
    /// <value>The default is "rabit".</value>
    public string Name { get; set; } = "rabit";

    /// <summary>
    /// Whether the status holds how long units of work take and how late they begin. It costs well below a microsecond
    /// per run.
    /// </summary>
    /// <value>The default is true.</value>
    public bool KeepsStatistics { get; set; } = true;

    /// <summary>
    /// How long a manager may be in its code before it hangs, and what follows, where the manager says nothing else
    /// (<see cref="RabitManager.HangPolicy"/>).
    /// </summary>
    /// <value>The default is <see cref="HangPolicy.Report"/>.</value>
    public HangPolicy HangPolicy { get; set; } = HangPolicy.Report;

    /// <summary>
    /// How long each manager, reader and writer may take to stop before it is reported as not stopped, where the
    /// manager says nothing else (<see cref="RabitManager.StopTimeout"/>). A writer that is stuck may take it twice: to
    /// write what is left, and to give up.
    /// </summary>
    /// <value>The default is 2 s.</value>
    public TimeSpan StopTimeout { get; set; } = TimeSpan.FromSeconds(2);

    /// <summary>
    /// How long all of them may take together. When it is over, all that are left are asked to stop at once, out of
    /// order, and get 20 ms each. In virtual time a stop takes no time.
    /// </summary>
    /// <value>The default is 10 s.</value>
    public TimeSpan TotalStopTimeout { get; set; } = TimeSpan.FromSeconds(10);

    /// <summary>Whether Ctrl-C and SIGTERM stop the run in order instead of ending the process.</summary>
    /// <value>The default is true.</value>
    public bool StopsOnSignals { get; set; } = true;

    internal ReactorOptions Copy() => (ReactorOptions)MemberwiseClone();

    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    internal void Validate(string parameter)
    {
        var faults = new List<string>();
        if (Time is null)
            faults.Add($"{nameof(Time)} is null.");
        if (string.IsNullOrWhiteSpace(Name))
            faults.Add($"{nameof(Name)} is empty.");
        if (HangPolicy is null)
            faults.Add($"{nameof(HangPolicy)} is null.");
        if (TotalStopTimeout <= TimeSpan.Zero || TotalStopTimeout > TimeSpan.FromHours(1))
            faults.Add($"{nameof(TotalStopTimeout)} is {TotalStopTimeout}; it must be above zero and at most an hour.");
        if (StopTimeout <= TimeSpan.Zero || StopTimeout > TimeSpan.FromHours(1))
            faults.Add($"{nameof(StopTimeout)} is {StopTimeout}; it must be above zero and at most an hour.");
        if (faults.Count > 0)
            throw new ArgumentException("The reactor cannot be made: " + string.Join(" ", faults), parameter);
    }
}
