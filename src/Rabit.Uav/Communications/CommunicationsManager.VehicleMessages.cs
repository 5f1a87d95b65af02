using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

// What Communications sends by itself: our position, and messages for other vehicles.
public sealed partial class CommunicationsManager
{
    // Senders push all they saw in one picture at once.
    private const int VehicleMessagesWaiting = 256;

    private readonly MessageSubscriber<VehicleState> _vehicle;
    private readonly OwnPosition _position;
    private readonly VehicleMessageChannel[] _channels;

    /// <summary>What became of the vehicle messages, type by type in the order of the routes. Any thread.</summary>
    public IReadOnlyList<VehicleMessageCounters> CountVehicleMessages() => _channels.Select(m => m.Counts).ToArray();

    internal QueueReceiver<Envelope<T>> ReceiveVehicleMessages<T>(string queue)
        where T : struct
        => Receive<Envelope<T>>(queue, VehicleMessagesWaiting, QueueFullMode.DropOldest);

    internal QueueSender<T> SendVehicleMessages<T>(string queue)
        where T : struct
        => Send<T>(queue);

    private void SendPosition()
    {
        _vehicle.Fetch();
        OwnAddress own = _ownAddress.Value;
        if (own.IsKnown && _position.TryNext(_vehicle.Value, Now, out GlobalPositionInt message))
            SendPosition(MavlinkFrame.Create(message, own.SystemId, own.ComponentId, sequence: 0));
    }

    private void SendPosition(in MavlinkFrame frame)
    {
        _options.Dialect.TryGetMessage(frame.MessageId, out MavlinkMessageInfo message);
        ulong links = _router.RouteOwn(frame, message);
        foreach (LinkPort port in _ports)
        {
            if (!port.TakesPosition)
                links &= ~(1UL << port.Number);
        }

        SendOwn(links, frame, message.CrcExtra);
    }

    private void SendOwn(in MavlinkFrame frame)
    {
        _options.Dialect.TryGetMessage(frame.MessageId, out MavlinkMessageInfo message);
        SendOwn(_router.RouteOwn(frame, message), frame, message.CrcExtra);
    }

    private void SendVehicleMessages()
    {
        OwnAddress own = _ownAddress.Value;
        foreach (VehicleMessageChannel channel in _channels)
        {
            while (channel.TryTake(Now, out Tunnel? tunnel))
            {
                if (tunnel is not { } message)
                    continue;
                if (own.IsKnown)
                    SendVehicleMessages(
                        channel, MavlinkFrame.Create(message, own.SystemId, own.ComponentId, sequence: 0));
                else
                    channel.CountUnsendable();
            }
        }
    }

    // A number is taken only for a frame that goes out: a gap would look like a loss.
    private void SendVehicleMessages(VehicleMessageChannel channel, in MavlinkFrame frame)
    {
        _options.Dialect.TryGetMessage(frame.MessageId, out MavlinkMessageInfo message);
        ulong links = _router.RouteOwn(frame, message);
        if (links == 0)
            channel.CountUnsendable();

        ulong sent = 0;
        foreach (LinkPort port in _ports)
        {
            ulong link = 1UL << port.Number;
            if ((links & link) == 0)
                continue;
            if (!port.TryTakeRate(frame, Now))
            {
                channel.CountRateLimited();
                continue;
            }

            sent |= link;
            channel.CountSent();
        }

        if (sent != 0)
            SendOwn(sent, frame, message.CrcExtra);
    }

    /// <returns>
    /// Whether it is a vehicle message of a type that has a route, which does not concern the autopilot.
    /// </returns>
    private bool TakeVehicleMessage(in LinkFrame frame)
    {
        MavlinkFrame mavlink = frame.Frame;
        if (_channels.Length == 0 || mavlink.MessageId != Tunnel.MavlinkId)
            return false;
        mavlink.TryDecode(out Tunnel tunnel);
        foreach (VehicleMessageChannel channel in _channels)
        {
            if (channel.PayloadType != (int)tunnel.PayloadType)
                continue;
            channel.Take(mavlink, tunnel, _ownAddress.Value.SystemId, frame.Time);
            return true;
        }

        return false;
    }
}
