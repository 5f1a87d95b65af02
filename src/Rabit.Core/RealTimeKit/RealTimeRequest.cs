using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Core;

/// <summary>
/// What a manager asks of the machine for its thread; see <see cref="RabitManager.RequestRealTime"/>. Options left at
/// their defaults are not requested. Only Linux grants any of it, and each part by itself.
/// </summary>
public sealed class RealTimeRequest
{
    private const int MaxPriority = 99;   // sched_get_priority_max of SCHED_FIFO and SCHED_RR on Linux
    private const int MaxCpu = 1023;      // the set of CPUs that libc's calls take
    private const int MaxWarmUpRuns = 1_000_000;
    private static readonly TimeSpan MaxTimerSlack = TimeSpan.FromSeconds(1);

    private IReadOnlyList<int> _cpus = [];

    /// <summary>The real-time priority: 1, the lowest, to 99. Null, the default, for the ordinary scheduler.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no such priority.</exception>
    public int? Priority
    {
        get;
        set => field = value is null or (>= 1 and <= MaxPriority)
            ? value
            : throw new ArgumentOutOfRangeException(
                nameof(value), value, $"A real-time priority is from 1 to {MaxPriority}.");
    }

    /// <summary>How threads of one priority share a CPU; it counts with a <see cref="Priority"/> only.</summary>
    /// <value>The default is <see cref="RealTimePolicy.Fifo"/>.</value>
    /// <exception cref="ArgumentOutOfRangeException">There is no such policy.</exception>
    public RealTimePolicy Policy
    {
        get;
        set => field = value is RealTimePolicy.Fifo or RealTimePolicy.RoundRobin
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "There is no such real-time policy.");
    }

    /// <summary>
    /// Whether a unit of work may busy-wait. Nothing in Rabit spins by itself; a manager whose own code does says so
    /// here. Its priority is refused if the spinning managers of the run could then occupy every CPU: the collector,
    /// and whatever else the machine does, would stop.
    /// </summary>
    public bool Spins { get; set; }

    /// <summary>
    /// The CPUs on which the thread may run, counted from 0. Empty, the default, for all that the process may use.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of the range 0 to 1023.</exception>
    public IReadOnlyList<int> Cpus
    {
        get => _cpus;
        set
        {
            int[] cpus = [.. Require.NotNull(value, nameof(value)).Distinct().OrderBy(cpu => cpu)];
            if (cpus.Length > 0 && (cpus[0] < 0 || cpus[cpus.Length - 1] > MaxCpu))
                throw new ArgumentOutOfRangeException(
                    nameof(value), string.Join(", ", cpus), $"The number of a CPU is from 0 to {MaxCpu}.");
            _cpus = cpus;
        }
    }

    /// <summary>
    /// Whether memory that was touched stays in memory: no page of it is written to disk or dropped. For the whole
    /// process, to its end.
    /// </summary>
    public bool LocksMemory { get; set; }

    /// <summary>
    /// How late the kernel may make the timer of the thread to save power: 50 µs by default. A thread with a real-time
    /// priority has none.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Zero or negative, or longer than a second.</exception>
    public TimeSpan? TimerSlack
    {
        get;
        set => field = value is null || (value > TimeSpan.Zero && value <= MaxTimerSlack)
            ? value
            : throw new ArgumentOutOfRangeException(
                nameof(value), value, "The timer slack must be longer than zero and at most a second.");
    }

    /// <summary>
    /// How often <see cref="RabitManager.WarmUp"/> is called before <see cref="RabitManager.Startup"/>. If it is above
    /// zero the code of the manager's class is also compiled ahead, so that its first unit of work does not wait for
    /// the compiler. 30 calls bring .NET to compile the best code soon.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Negative, or more than a million.</exception>
    public int WarmUpRuns
    {
        get;
        set => field = value is >= 0 and <= MaxWarmUpRuns
            ? value
            : throw new ArgumentOutOfRangeException(
                nameof(value), value, $"The number of warm-up runs is from 0 to {MaxWarmUpRuns}.");
    }

    internal RealTimeRequest Copy() => (RealTimeRequest)MemberwiseClone();
}
