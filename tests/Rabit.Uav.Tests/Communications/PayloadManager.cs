using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.Communications;

/// <summary>
/// A manager of a user: receives one type of message over a subscription, and sends as a component of its own.
/// </summary>
internal sealed class PayloadManager<T> : RabitManager
    where T : struct, IMavlinkMessage
{
    private readonly MavlinkMessageReceiver<T> _receiver;
    private readonly MavlinkMessageSender _sender;

    public PayloadManager(
        string queue, int capacity = 64, QueueFullMode fullMode = QueueFullMode.DropOldest, byte? componentId = null,
        bool isStuck = false)
        : base(queue + " manager")
    {
        _receiver = new MavlinkMessageReceiver<T>(Receive<LinkFrame>(queue, capacity, fullMode, wakeOnPush: !isStuck));
        _sender = new MavlinkMessageSender(
            Send<OutgoingFrame>(MessageNames.OutgoingFrames), Subscribe<OwnAddress>(MessageNames.OwnAddress),
            componentId);
        WakeUpDelay = isStuck ? TimeSpan.FromHours(1) : TimeSpan.FromMilliseconds(10);
        IsStuck = isStuck;
    }

    /// <summary>Whether it takes nothing out of its queue.</summary>
    public bool IsStuck { get; }

    public List<T> Taken { get; } = [];

    public List<LinkFrame> Frames { get; } = [];

    public long Undecoded => _receiver.Undecoded;

    public long NotSent => _sender.NotSent;

    /// <summary>Sent in the next unit of work.</summary>
    public T? ToSend { get; set; }

    protected override void ExecuteUnitOfWork()
    {
        if (ToSend is { } message)
            _sender.TrySend(message);
        ToSend = null;
        while (!IsStuck && _receiver.TryPop(out T received, out LinkFrame frame))
        {
            Taken.Add(received);
            Frames.Add(frame);
        }
    }
}
