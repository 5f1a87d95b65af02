using System;

namespace Rabit.Uav.Communications;

/// <summary>
/// How one type of message travels between vehicles; see <see cref="VehicleMessageRoute{T}"/>. Communications carries
/// it without knowing what it means.
/// </summary>
public abstract class VehicleMessageRoute
{
    /// <summary>The most bytes that one message may have: the payload of TUNNEL (common.xml, 385).</summary>
    public const int MaxLength = 128;

    internal const int MinPayloadType = 32768;
    internal const int MaxPayloadType = 65535;

    private protected VehicleMessageRoute(int payloadType, string outgoingQueue, string incomingQueue)
    {
        if (payloadType is < MinPayloadType or > MaxPayloadType)
        {
            throw new ArgumentException(
                $"Payload type {payloadType} of a vehicle message is not one of {MinPayloadType} to {MaxPayloadType}, "
                    + "which are free for private use.",
                nameof(payloadType));
        }

        if (string.IsNullOrEmpty(outgoingQueue))
            throw new ArgumentException("The queue of outgoing messages has no name.", nameof(outgoingQueue));
        if (string.IsNullOrEmpty(incomingQueue))
            throw new ArgumentException("The queue of incoming messages has no name.", nameof(incomingQueue));
        PayloadType = payloadType;
        OutgoingQueue = outgoingQueue;
        IncomingQueue = incomingQueue;
    }

    /// <summary>Says on the wire what it is.</summary>
    public int PayloadType { get; }

    /// <summary>
    /// The queue of <see cref="Messages.Envelope{T}"/> that Communications receives: what is to be sent.
    /// </summary>
    public string OutgoingQueue { get; }

    /// <summary>The queue that Communications sends to: what came in, without its envelope.</summary>
    public string IncomingQueue { get; }

    internal abstract VehicleMessageChannel Open(CommunicationsManager manager);
}
