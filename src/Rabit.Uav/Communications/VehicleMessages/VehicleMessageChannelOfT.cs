using System;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>One route of vehicle messages at work.</summary>
internal sealed class VehicleMessageChannel<T>(
    VehicleMessageRoute route, IVehicleMessageCodec<T> codec, QueueReceiver<Envelope<T>> outgoing,
    QueueSender<Envelope<T>> incoming, QueueSender<DeliveryReport>? reports)
    : VehicleMessageChannel(route, reports)
    where T : struct
{
    private readonly byte[] _buffer = new byte[VehicleMessageRoute.MaxLength];

    private protected override bool TryTake(TimeSpan now, out ExchangeMessage? message, out DeliveryReport refused)
    {
        (message, refused) = (null, default);
        if (!outgoing.TryPop(out Envelope<T> envelope))
            return false;
        refused.Reference = envelope.Reference;
        TimeSpan left = LifetimeOf(envelope, now);
        if (left <= TimeSpan.Zero)
            refused.Outcome = DeliveryOutcome.Expired;
        else if (!codec.TryEncode(envelope.Content, now, _buffer, out int length) || (uint)length > _buffer.Length)
            refused.Outcome = DeliveryOutcome.Unsendable;
        else
            message = Make(envelope, left, length);
        return true;
    }

    private ExchangeMessage Make(in Envelope<T> envelope, TimeSpan lifetime, int length) => new()
    {
        Type = (ushort)Route.MessageType,
        Version = (byte)Route.Version,
        Content = _buffer.AsSpan(0, length).ToArray(),
        Destination = envelope.Destination,
        Class = Route.Class,
        Lifetime = lifetime,
        HopLimit = Route.HopLimit,
        IsAcknowledged = Route.IsAcknowledged,
        Reference = envelope.Reference,
    };

    private protected override DeliveryResult Deliver(
        ReceivedExchangeMessage message, TimeSpan sentTime, TimeSpan? accuracy)
    {
        if (!codec.TryDecode(message.Content, message.Version, sentTime, message.SourceSystemId, out T content))
            return DeliveryResult.Malformed;
        var envelope = new Envelope<T>
        {
            Content = content,
            Destination = message.Destination,
            SourceSystemId = message.SourceSystemId,
            SentTime = sentTime,
            TimeAccuracy = accuracy,
            SentUtcMicroseconds = message.SentUtcMicroseconds,
            IsRelayed = message.IsRelayed,
        };
        return incoming.Push(envelope) == PushResult.Rejected ? DeliveryResult.NoRoom : DeliveryResult.Delivered;
    }

    private TimeSpan LifetimeOf(in Envelope<T> envelope, TimeSpan now)
    {
        TimeSpan left = envelope.ValidUntil - now;
        return envelope.ValidUntil == TimeSpan.Zero || left > Route.Lifetime ? Route.Lifetime : left;
    }
}
