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
    /// Where the log goes; called on the thread that writes the entry, so it must be thread-safe. Where it throws, that
    /// is ignored, and a fault or hang that it did not take goes to standard error.
    /// </summary>
    /// <value>
    /// Null, the default: faults and hangs go to standard error, a line each, ten at once and then one a second at
    /// most. A log that does nothing, <c>_ =&gt; { }</c>, switches that off. Whatever the log, the result has how many
    /// there were of each manager, and the first ten of each; faults of readers and writers are with these alone.
    /// </value>
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
    /// How long a requested stop waits at most while managers delay it (<see cref="RabitManager.DelaysStop"/>), by the
    /// clock of the run; the stop itself begins after that. When it is over, the stop continues and the result names
    /// the managers (<see cref="ReactorResult.StillDelaying"/>).
    /// </summary>
    /// <value>The default is zero: a stop waits for none and causes no further unit of work.</value>
    public TimeSpan MaxStopDelay { get; set; }

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

    /// <summary>
    /// Whether Ctrl-C, SIGTERM and SIGHUP (the terminal was closed) stop the run in order instead of ending the
    /// process, while <see cref="RabitReactor.Run"/> or <see cref="RabitReactor.RunAsync"/> runs it: a program that
    /// calls <see cref="RabitReactor.Start"/> acts on signals itself. A SIGHUP that the process was started to ignore,
    /// as by <c>nohup</c>, stays ignored. Ctrl-\ (SIGQUIT) and Ctrl-Break keep their own meaning.
    /// </summary>
    /// <value>The default is true.</value>
    public bool StopsOnSignals { get; set; } = true;

    /// <summary>
    /// Whether a queue of a type that sender and receiver could share and change, such as a list, is a fault of the
    /// wiring. See <see cref="HandedOverAttribute"/>.
    /// </summary>
    /// <value>The default is false: it is a note in the log.</value>
    public bool RefusesMutableQueueTypes { get; set; }

    internal ReactorOptions Copy() => (ReactorOptions)MemberwiseClone();

    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    internal void Validate(string parameter)
    {
        var faults = new List<string>();
        if (Time is null)
            faults.Add($"{nameof(Time)} is null.");
        if (string.IsNullOrWhiteSpace(Name))
            faults.Add($"{nameof(Name)} is empty.");
        else if (Name.IndexOfAny(['\r', '\n']) >= 0)
            faults.Add($"{nameof(Name)} has a line break.");
        if (HangPolicy is null)
            faults.Add($"{nameof(HangPolicy)} is null.");
        if (TotalStopTimeout <= TimeSpan.Zero || TotalStopTimeout > TimeSpan.FromHours(1))
            faults.Add($"{nameof(TotalStopTimeout)} is {TotalStopTimeout}; it must be above zero and at most an hour.");
        if (MaxStopDelay < TimeSpan.Zero || MaxStopDelay > TimeSpan.FromHours(1))
            faults.Add($"{nameof(MaxStopDelay)} is {MaxStopDelay}; it must be zero or above and at most an hour.");
        if (StopTimeout <= TimeSpan.Zero || StopTimeout > TimeSpan.FromHours(1))
            faults.Add($"{nameof(StopTimeout)} is {StopTimeout}; it must be above zero and at most an hour.");
        if (faults.Count > 0)
            throw new ArgumentException("The reactor cannot be made: " + string.Join(" ", faults), parameter);
    }
}
