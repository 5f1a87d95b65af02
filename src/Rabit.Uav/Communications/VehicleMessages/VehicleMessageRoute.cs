using System;
using System.Collections.Generic;

namespace Rabit.Uav.Communications;

/// <summary>
/// How one type of message travels between vehicles; see <see cref="VehicleMessageRoute{T}"/>. Communications carries
/// it without knowing what it means.
/// </summary>
public abstract class VehicleMessageRoute
{
    /// <summary>The most bytes that one message may have: 32 fragments.</summary>
    public const int MaxLength = ExchangeWire.MaxContent;

    private protected VehicleMessageRoute(int messageType, int version, string outgoingQueue, string incomingQueue)
    {
        if (messageType is < 0 or > ushort.MaxValue)
            throw new ArgumentException(
                $"Type {messageType} of a vehicle message is not one of 0 to {ushort.MaxValue}.", nameof(messageType));
        if (version is < 0 or > byte.MaxValue)
            throw new ArgumentException(
                $"Version {version} of vehicle messages of type {messageType} is not one of 0 to {byte.MaxValue}.",
                nameof(version));
        if (string.IsNullOrEmpty(outgoingQueue))
            throw new ArgumentException("The queue of outgoing messages has no name.", nameof(outgoingQueue));
        if (string.IsNullOrEmpty(incomingQueue))
            throw new ArgumentException("The queue of incoming messages has no name.", nameof(incomingQueue));
        (MessageType, Version) = (messageType, version);
        OutgoingQueue = outgoingQueue;
        IncomingQueue = incomingQueue;
    }

    /// <summary>Says on the wire what it is.</summary>
    public int MessageType { get; }

    /// <summary>The version of its form.</summary>
    public int Version { get; }

    /// <summary>
    /// The queue of <see cref="Messages.Envelope{T}"/> that Communications receives: what is to be sent.
    /// </summary>
    public string OutgoingQueue { get; }

    /// <summary>
    /// The queue of <see cref="Messages.Envelope{T}"/> that Communications sends to: what other vehicles sent.
    /// </summary>
    public string IncomingQueue { get; }

    /// <summary>
    /// The queue of <see cref="Messages.DeliveryReport"/> that Communications sends to: what became of each message
    /// that was taken from the outgoing queue. Null for none.
    /// </summary>
    /// <value>The default is null.</value>
    public string? ReportQueue { get; init; }

    /// <summary>How urgent its messages are.</summary>
    /// <value>The default is <see cref="VehicleMessageClass.Coordination"/>.</value>
    public VehicleMessageClass Class { get; init; } = VehicleMessageClass.Coordination;

    /// <summary>
    /// How long a message is worth anything from when it was pushed, up to 10 minutes; its envelope may say less.
    /// </summary>
    /// <value>The default is 10 s.</value>
    public TimeSpan Lifetime { get; init; } = TimeSpan.FromSeconds(10);

    /// <summary>Over how many other vehicles a message may go, 0 to 7.</summary>
    /// <value>The default is 0.</value>
    public int HopLimit { get; init; }

    /// <summary>
    /// Whether its messages are acknowledged, and sent again until they are or their lifetime ends. Else they are sent
    /// once.
    /// </summary>
    /// <value>The default is false.</value>
    public bool IsAcknowledged { get; init; }

    internal IEnumerable<string> FindFaults()
    {
        if (Lifetime <= TimeSpan.Zero || Lifetime > MessageExchange.MaxLifetime)
            yield return $"{nameof(Lifetime)} is {Lifetime}; it must be above zero and at most "
                + MessageExchange.MaxLifetime;
        if (HopLimit is < 0 or > VehicleExchangeOptions.MaxHops)
            yield return $"{nameof(HopLimit)} is {HopLimit}; it must be 0 to {VehicleExchangeOptions.MaxHops}";
        if (Class is < VehicleMessageClass.Urgent or > VehicleMessageClass.Bulk)
            yield return $"{nameof(Class)} is {Class:D}, which is no class";
        if (ReportQueue?.Length == 0)
            yield return $"{nameof(ReportQueue)} is empty; it must be a name, or null";
    }

    internal abstract VehicleMessageChannel Open(CommunicationsManager manager);
}
