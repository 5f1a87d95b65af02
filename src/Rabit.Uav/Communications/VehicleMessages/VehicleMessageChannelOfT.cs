using System;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>One route of vehicle messages at work.</summary>
internal sealed class VehicleMessageChannel<T>(
    VehicleMessageRoute route, IVehicleMessageCodec<T> codec, QueueReceiver<Envelope<T>> outgoing,
    QueueSender<T> incoming)
    : VehicleMessageChannel(route)
    where T : struct
{
    private readonly RecentVehicleMessages _recent = new();
    private readonly byte[] _buffer = new byte[VehicleMessageRoute.MaxLength];

    public override bool TryTake(TimeSpan now, out Tunnel? tunnel)
    {
        tunnel = null;
        if (!outgoing.TryPop(out Envelope<T> envelope))
            return false;
        if (!codec.TryEncode(envelope.Content, now, _buffer, out int length) || length > _buffer.Length)
        {
            CountUnsendable();
            return true;
        }

        tunnel = new Tunnel
        {
            TargetSystem = envelope.TargetSystemId,
            PayloadType = (MavTunnelPayloadType)PayloadType,
            PayloadLength = (byte)length,
            Payload = new ByteArray128(new ReadOnlySpan<byte>(_buffer, 0, length)),
        };
        return true;
    }

    private protected override DeliveryResult Deliver(byte sourceSystemId, Tunnel tunnel, TimeSpan time)
    {
        ByteArray128 payload = tunnel.Payload;
        payload.CopyTo(_buffer);
        if (!codec.TryDecode(
            new ReadOnlySpan<byte>(_buffer, 0, tunnel.PayloadLength), time, sourceSystemId, out T content))
            return DeliveryResult.Malformed;
        if (!_recent.IsNew(sourceSystemId, codec.IdentityOf(content), time))
            return DeliveryResult.Duplicate;
        return incoming.Push(content) == PushResult.Rejected ? DeliveryResult.NoRoom : DeliveryResult.Delivered;
    }
}
