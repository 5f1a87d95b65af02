using System;
using Rabit.Core.Supervision;

namespace Rabit.Core;

/// <summary>
/// Whether a reader or writer opens its device again after a fault: it closes it, waits, opens it, and continues.
/// Immutable.
/// </summary>
/// <remarks>
/// For a source or target that can be opened again after it was closed. A value that a target threw at is lost and
/// counted, since it may be half written; what waits in the queue is kept.
/// </remarks>
public sealed class ReconnectPolicy
{
    private ReconnectPolicy(TimeSpan firstDelay, TimeSpan maxDelay, int maxAttempts)
    {
        FirstDelay = firstDelay;
        MaxDelay = maxDelay;
        MaxAttempts = maxAttempts;
    }

    /// <summary>The default: the first fault ends the reader or writer.</summary>
    public static ReconnectPolicy Never { get; } = new(TimeSpan.Zero, TimeSpan.Zero, maxAttempts: 0);

    /// <summary>
    /// Tries again after 100 ms, a delay that doubles with every further fault up to 5 s, for as long as the run lasts.
    /// </summary>
    public static ReconnectPolicy Always { get; } = After(TimeSpan.FromMilliseconds(100), TimeSpan.FromSeconds(5));

    /// <summary>The delay after the first of several faults.</summary>
    public TimeSpan FirstDelay { get; }

    /// <summary>The longest delay.</summary>
    public TimeSpan MaxDelay { get; }

    /// <summary>
    /// How many times in a row it is tried before the reader or writer ends faulted. A value that was read or written
    /// ends a row.
    /// </summary>
    public int MaxAttempts { get; }

    /// <summary>As <see cref="Always"/>, with other figures.</summary>
    /// <param name="firstDelay">
    /// After the first fault; longer than zero, or a device that is not there would take a whole core.
    /// </param>
    /// <param name="maxDelay">Where the doubling ends; not below the first.</param>
    /// <param name="maxAttempts">See <see cref="MaxAttempts"/>; at least one.</param>
    /// <exception cref="ArgumentOutOfRangeException">An argument is out of its range.</exception>
    public static ReconnectPolicy After(TimeSpan firstDelay, TimeSpan maxDelay, int maxAttempts = int.MaxValue)
    {
        BackOff.Check(firstDelay, maxDelay, "before a device is opened again");
        if (maxAttempts < 1)
            throw new ArgumentOutOfRangeException(
                nameof(maxAttempts), maxAttempts,
                "A device must be opened again at least once; or say ReconnectPolicy.Never.");
        return new ReconnectPolicy(firstDelay, maxDelay, maxAttempts);
    }
}
