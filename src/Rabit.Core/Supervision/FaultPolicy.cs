using System;
using Rabit.Core.Supervision;

namespace Rabit.Core;

/// <summary>
/// What happens after an exception left a manager's code. It is in the log, the status and the result under every
/// policy. Immutable.
/// </summary>
/// <remarks>
/// An exception in Shutdown is reported and changes nothing: the manager is ending, or about to be restarted, already.
/// </remarks>
/// <example>
/// <code>
/// var camera = new Camera { FaultPolicy = FaultPolicy.Restart };
/// var logger = new Logger
/// {
///     FaultPolicy = FaultPolicy.CarryOnAfter(TimeSpan.FromMilliseconds(50), TimeSpan.FromSeconds(5)),
/// };
/// </code>
/// </example>
public sealed class FaultPolicy
{
    private FaultPolicy(FaultAction action) => Action = action;

    /// <summary>The default: all managers are stopped in order, and the run ends with exit code 1.</summary>
    public static FaultPolicy StopSystem { get; } = new(FaultAction.StopSystem);

    /// <summary>
    /// This manager is shut down, with its readers and writers, and the others continue; the run will end with exit
    /// code 1. Its messages keep their last values. Its queues stay: they fill up, and what is pushed then meets their
    /// rule for a full queue.
    /// </summary>
    public static FaultPolicy StopManager { get; } = new(FaultAction.StopManager);

    /// <summary>
    /// The manager carries on after a delay of 10 ms that doubles with every further fault, up to 1 s, and is reset
    /// by a unit of work without a fault. Wake-ups that come during the delay are kept.
    /// </summary>
    public static FaultPolicy CarryOn { get; } = CarryOnAfter(TimeSpan.FromMilliseconds(10), TimeSpan.FromSeconds(1));

    /// <summary>
    /// The manager is shut down and, after 100 ms, started up again: the same object on the same thread, with its
    /// queues and messages. The delay doubles with every restart within a minute, up to 10 s; a sixth one within a
    /// minute stops the system instead.
    /// </summary>
    public static FaultPolicy Restart { get; } = RestartAfter(
        TimeSpan.FromMilliseconds(100), TimeSpan.FromSeconds(10), maxRestarts: 5, TimeSpan.FromMinutes(1));

    /// <summary>What follows a fault.</summary>
    public FaultAction Action { get; }

    /// <summary>The delay after the first of several faults; zero where nothing follows a delay.</summary>
    public TimeSpan FirstDelay { get; private init; }

    /// <summary>The longest delay; zero where nothing follows a delay.</summary>
    public TimeSpan MaxDelay { get; private init; }

    /// <summary>How many restarts there may be within <see cref="Window"/>; zero for other policies.</summary>
    public int MaxRestarts { get; private init; }

    /// <summary>For how long a restart is counted; zero for other policies.</summary>
    public TimeSpan Window { get; private init; }

    /// <summary>What follows a fault instead of one restart too many.</summary>
    public FaultAction Finally { get; private init; }

    /// <summary>As <see cref="CarryOn"/>, with other delays.</summary>
    /// <param name="firstDelay">
    /// After the first fault; longer than zero, or a manager that always throws would take a whole core.
    /// </param>
    /// <param name="maxDelay">Where the doubling ends; not below the first.</param>
    /// <exception cref="ArgumentOutOfRangeException">A delay is out of its range.</exception>
    public static FaultPolicy CarryOnAfter(TimeSpan firstDelay, TimeSpan maxDelay)
    {
        BackOff.Check(firstDelay, maxDelay, "after a fault");
        return new FaultPolicy(FaultAction.CarryOn) { FirstDelay = firstDelay, MaxDelay = maxDelay };
    }

    /// <summary>As <see cref="Restart"/>, with other figures.</summary>
    /// <param name="firstDelay">
    /// Between shutdown and start-up; longer than zero, or a manager that always throws would take a whole core.
    /// </param>
    /// <param name="maxDelay">Where the doubling with each restart within the window ends; not below the first.</param>
    /// <param name="maxRestarts">How many restarts there may be within the window, 1 to 1000.</param>
    /// <param name="window">For how long a restart is counted.</param>
    /// <param name="finally">
    /// What follows a fault after that many: <see cref="FaultAction.StopSystem"/> or
    /// <see cref="FaultAction.StopManager"/>.
    /// </param>
    /// <exception cref="ArgumentOutOfRangeException">An argument is out of its range.</exception>
    public static FaultPolicy RestartAfter(
        TimeSpan firstDelay, TimeSpan maxDelay, int maxRestarts, TimeSpan window,
        FaultAction @finally = FaultAction.StopSystem)
    {
        BackOff.Check(firstDelay, maxDelay, "before a restart");
        if (maxRestarts is < 1 or > 1000)
            throw new ArgumentOutOfRangeException(
                nameof(maxRestarts), maxRestarts, "A manager may be restarted 1 to 1000 times within its window.");
        Require.Positive(window, nameof(window), "The window in which restarts are counted");
        if (@finally is not (FaultAction.StopSystem or FaultAction.StopManager))
            throw new ArgumentOutOfRangeException(
                nameof(@finally), @finally, "Restarts end with a stop, of the system or of the manager.");
        return new FaultPolicy(FaultAction.Restart)
        {
            FirstDelay = firstDelay,
            MaxDelay = maxDelay,
            MaxRestarts = maxRestarts,
            Window = window,
            Finally = @finally,
        };
    }
}
