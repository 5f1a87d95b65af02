using System;
using System.Threading;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// Receives the messages of one type from the queue of a <see cref="MavlinkSubscription"/>. Belongs to the manager
/// whose queue it is; allocates nothing per message.
/// </summary>
/// <typeparam name="T">A generated message, of our dialects or of yours.</typeparam>
/// <param name="queue">
/// The queue; the subscription should name this message alone, since other frames in it are passed over.
/// </param>
/// <exception cref="ArgumentNullException">No queue.</exception>
public sealed class MavlinkMessageReceiver<T>(QueueReceiver<LinkFrame> queue)
    where T : struct, IMavlinkMessage
{
    private readonly QueueReceiver<LinkFrame> _queue = queue ?? throw new ArgumentNullException(nameof(queue));
    private long _undecoded;

    /// <summary>Frames in the queue that were no such message, and were passed over. Any thread.</summary>
    public long Undecoded => Interlocked.Read(ref _undecoded);

    /// <summary>Takes the oldest message out of the queue. Never waits. The manager's thread only.</summary>
    /// <param name="message">The message; <c>default</c> where there is none.</param>
    /// <param name="frame">Its frame: source, link and time.</param>
    /// <returns>False when the queue is empty.</returns>
    /// <exception cref="InvalidOperationException">
    /// The manager is not the one that runs on this thread, or nothing is wired yet.
    /// </exception>
    public bool TryPop(out T message, out LinkFrame frame)
    {
        while (_queue.TryPop(out frame))
        {
            if (frame.Frame.TryDecode(out message))
                return true;
            Interlocked.Increment(ref _undecoded);
        }

        message = default;
        return false;
    }
}
