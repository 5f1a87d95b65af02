using System;
using System.Threading;
using System.Threading.Tasks;

namespace Rabit.Core.Queues;

/// <summary>
/// A push of async code that waits for room. It ends once: put in, timed out, cancelled, or at the end of the run.
/// </summary>
internal sealed class PendingPush<T>(T value, TimeSpan due)
    : TaskCompletionSource<PushResult>(TaskCreationOptions.RunContinuationsAsynchronously)
{
    // set once, with an exchange, by what ends the wait: the queue under its lock, or a cancellation on any thread
    private int _isClaimed;

    public T Value { get; } = value;

    /// <summary>When it gives up, by the clock of the run.</summary>
    public TimeSpan Due { get; } = due;

    public bool IsClaimed => Volatile.Read(ref _isClaimed) != 0;

    public bool TryClaim() => Interlocked.Exchange(ref _isClaimed, 1) == 0;
}
