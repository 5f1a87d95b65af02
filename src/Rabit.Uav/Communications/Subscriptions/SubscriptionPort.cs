using System.Linq;
using System.Threading;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// One subscription as Communications serves it. The manager's thread delivers, any thread reads the counters.
/// </summary>
internal sealed class SubscriptionPort(MavlinkSubscription subscription, QueueSender<LinkFrame> queue)
{
    private readonly int[] _messageIds = subscription.MessageIds.ToArray();
    private readonly byte? _componentId = subscription.ComponentId;
    private long _delivered;
    private long _dropped;

    public string Queue => subscription.Queue;

    public MavlinkSubscriptionCounters Counters
        => new(Queue, Interlocked.Read(ref _delivered), Interlocked.Read(ref _dropped));

    /// <summary>When its drops are logged.</summary>
    public DropReport Drops { get; } = new();

    public bool Includes(int messageId) => _messageIds.Length == 0 || _messageIds.Contains(messageId);

    /// <param name="frame">A frame of a message that it includes.</param>
    /// <param name="systemId">Our own.</param>
    /// <param name="isForComputer">Whether the frame is for the component that this computer is.</param>
    public void Deliver(in LinkFrame frame, byte systemId, bool isForComputer)
    {
        if (_componentId is { } component ? !frame.IsFor(systemId, component) : !isForComputer)
            return;

        // Where an older frame was dropped for this one, as many are in the queue or popped as before.
        if (queue.Push(frame) == PushResult.Queued)
            Interlocked.Increment(ref _delivered);
        else
            Interlocked.Increment(ref _dropped);
    }
}
