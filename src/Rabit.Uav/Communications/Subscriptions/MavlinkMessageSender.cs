using System;
using System.Threading;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// Sends messages of a manager, from our own system and a component of it: Communications numbers, signs and routes
/// them. Belongs to the manager whose queue and message it is given; allocates nothing per message.
/// </summary>
/// <example>
/// In the constructor of a manager that is a gimbal, component 154, and in its unit of work:
/// <code>
/// _sender = new MavlinkMessageSender(
///     Send&lt;OutgoingFrame&gt;(MessageNames.OutgoingFrames),
///     Subscribe&lt;OwnAddress&gt;(MessageNames.OwnAddress),
///     componentId: 154);
/// </code>
/// <code>
/// _sender.TrySend(new Heartbeat { Type = MavType.Gimbal, Autopilot = MavAutopilot.Invalid, MavlinkVersion = 3 });
/// </code>
/// </example>
public sealed class MavlinkMessageSender
{
    private readonly QueueSender<OutgoingFrame> _outgoing;
    private readonly MessageSubscriber<OwnAddress> _ownAddress;
    private readonly byte? _componentId;
    private long _notSent;

    /// <summary>Makes the sender.</summary>
    /// <param name="outgoing">The manager's end of <see cref="MessageNames.OutgoingFrames"/>.</param>
    /// <param name="ownAddress">
    /// The manager's end of <see cref="MessageNames.OwnAddress"/>, from which our system id comes.
    /// </param>
    /// <param name="componentId">The component that sends, 1 to 255; null for the one that this computer is.</param>
    /// <exception cref="ArgumentNullException">An end is missing.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The component is 0.</exception>
    public MavlinkMessageSender(
        QueueSender<OutgoingFrame> outgoing, MessageSubscriber<OwnAddress> ownAddress, byte? componentId = null)
    {
        _outgoing = outgoing ?? throw new ArgumentNullException(nameof(outgoing));
        _ownAddress = ownAddress ?? throw new ArgumentNullException(nameof(ownAddress));
        if (componentId == 0)
            throw new ArgumentOutOfRangeException(
                nameof(componentId), componentId, "0 means every component; a sender is 1 to 255.");
        _componentId = componentId;
    }

    /// <summary>
    /// Messages that were not sent, because our system id was not known yet or the queue was full. Any thread.
    /// </summary>
    public long NotSent => Interlocked.Read(ref _notSent);

    /// <summary>
    /// Sends a message to the system and component that its target fields name, or to all links where it has none.
    /// Never waits. The manager's thread only.
    /// </summary>
    /// <typeparam name="T">A generated message; <see cref="CommunicationsOptions.Dialect"/> must have it.</typeparam>
    /// <param name="message">The fields.</param>
    /// <returns>
    /// False where it was not sent: our system id, which is that of the vehicle, is not known yet, or the queue
    /// rejected it.
    /// </returns>
    /// <exception cref="InvalidOperationException">
    /// The manager is not the one that runs on this thread, or nothing is wired yet.
    /// </exception>
    public bool TrySend<T>(in T message)
        where T : struct, IMavlinkMessage
    {
        _ownAddress.Fetch();
        OwnAddress own = _ownAddress.Value;
        bool isSent = own.IsKnown && Push(message, own) != PushResult.Rejected;
        if (!isSent)
            Interlocked.Increment(ref _notSent);
        return isSent;
    }

    private PushResult Push<T>(in T message, in OwnAddress own)
        where T : struct, IMavlinkMessage
        => _outgoing.Push(new OutgoingFrame
        {
            Frame = MavlinkFrame.Create(message, own.SystemId, _componentId ?? own.ComponentId, sequence: 0),
        });
}
