using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

// Messages between vehicles: from the queues of the routes through the exchange to the links, and back.
public sealed partial class CommunicationsManager
{
    // Senders push all they saw in one picture at once.
    private const int VehicleMessagesWaiting = 256;

    // While there is no room on a link for what is due, at the least: where its limit lets a datagram through, room for
    // another of the class comes as soon as one is sent.
    private static readonly TimeSpan RetryDelay = TimeSpan.FromTicks(20 * TimeSpan.TicksPerMillisecond);

    // While no link is open towards those that it is for.
    private static readonly TimeSpan NoLinkDelay = TimeSpan.FromTicks(250 * TimeSpan.TicksPerMillisecond);

    private readonly VehicleMessageChannel[] _channels;
    private readonly Dictionary<int, VehicleMessageChannel> _channelsByType = [];
    private readonly MessagePublisher<VehicleMessageStatus>? _vehicleMessageStatus;
    private readonly byte[] _datagram = new byte[ExchangeWire.MaxLength];
    private MessageExchange? _exchange; // from Startup on, where there are routes
    private TimeSpan _exchangeDue;
    private long _copiesHeldBack;

    /// <summary>What became of the vehicle messages, type by type in the order of the routes. Any thread.</summary>
    public IReadOnlyList<VehicleMessageCounters> CountVehicleMessages() => _channels.Select(m => m.Counts).ToArray();

    // What is acknowledged has a report; what the queue would drop would have none.
    internal QueueReceiver<Envelope<T>> ReceiveVehicleMessages<T>(string queue, bool isAcknowledged)
        where T : struct
        => Receive<Envelope<T>>(
            queue, VehicleMessagesWaiting, isAcknowledged ? QueueFullMode.Reject : QueueFullMode.DropOldest);

    internal QueueSender<Envelope<T>> SendVehicleMessages<T>(string queue)
        where T : struct
        => Send<Envelope<T>>(queue);

    internal QueueSender<DeliveryReport>? SendReports(string? queue)
        => queue is null ? null : Send<DeliveryReport>(queue);

    private VehicleMessageChannel[] OpenVehicleMessages()
    {
        VehicleMessageChannel[] channels = _options.VehicleMessageRoutes.Select(route => route.Open(this)).ToArray();
        foreach (VehicleMessageChannel channel in channels)
            _channelsByType.Add(channel.Route.MessageType, channel);
        return channels;
    }

    // The session of the exchange must be another one in the next run.
    private void StartExchange()
    {
        if (_channels.Length == 0)
            return;
        VehicleExchangeOptions options = _options.VehicleExchange.Copy();
        options.Announces ??= options.Groups.Count > 0 || _channels.Any(c => c.Route.IsAcknowledged);
        _exchange = new MessageExchange(
            options, systemId: 0, new ExchangeRandom(Clock.GetUtcNow().Ticks), RoomTowards);
        foreach (VehicleMessageChannel channel in _channels)
            _exchange.Understand((ushort)channel.Route.MessageType, (byte)channel.Route.Version);
    }

    private void ExchangeVehicleMessages()
    {
        if (_exchange is not { } exchange)
            return;
        OwnAddress own = _ownAddress.Value;
        exchange.SystemId = own.IsKnown ? own.SystemId : (byte)0;
        ref readonly VehicleState vehicle = ref _vehicle.Value;
        if (vehicle.UtcTime is { } time && vehicle.GpsUtcMicroseconds > 0)
            exchange.NoteGpsTime(vehicle.GpsUtcMicroseconds, time, lateBy: null);
        foreach (VehicleMessageChannel channel in _channels)
        {
            if (channel.Post(exchange, Now))
                _exchangeDue = Now;
        }

        if (Now >= _exchangeDue)
            SendDatagrams(exchange);
        TakeFrom(exchange);
    }

    private void SendDatagrams(MessageExchange exchange)
    {
        while (exchange.TryNext(Now, _datagram, out ExchangeDatagram datagram))
            Send(datagram);
        TimeSpan due = exchange.NextDue(Now);
        _exchangeDue = due > Now + RetryDelay ? due : Now + RetryDelay;
    }

    private void TakeFrom(MessageExchange exchange)
    {
        while (exchange.TryReceive(out ReceivedExchangeMessage? message))
        {
            TimeSpan sentTime = exchange.SentTimeOf(message!, Now, out TimeSpan? accuracy);
            _channelsByType[message!.Type].Take(message, sentTime, accuracy);
        }

        while (exchange.TryReport(out ExchangeMessage? message, out DeliveryReport report))
            _channelsByType[message!.Type].Report(report);
    }

    // A vehicle has us as this component, whatever else is on board.
    private void Send(in ExchangeDatagram datagram)
    {
        OwnAddress own = _ownAddress.Value;
        var tunnel = new Tunnel
        {
            TargetSystem = datagram.TargetSystem,
            TargetComponent = (byte)MavComponent.OnboardComputer,
            PayloadType = (MavTunnelPayloadType)ExchangeWire.PayloadType,
            PayloadLength = (byte)datagram.Length,
            Payload = new ByteArray128(new ReadOnlySpan<byte>(_datagram, 0, datagram.Length)),
        };
        MavlinkFrame frame = MavlinkFrame.Create(tunnel, own.SystemId, own.ComponentId, sequence: 0);
        _options.Dialect.TryGetMessage(frame.MessageId, out MavlinkMessageInfo message);
        ulong links = _router.RouteOwn(frame, message);
        SendCopies(
            frame, datagram.Links == 0 ? links : links & datagram.Links, message.CrcExtra,
            SendClasses.Of(datagram.Class));
    }

    private void SendCopies(in MavlinkFrame frame, ulong links, byte crcExtra, SendClass sendClass)
    {
        ulong sent = 0;
        foreach (LinkPort port in _ports)
        {
            ulong link = 1UL << port.Number;
            if ((links & link) == 0)
                continue;
            if (!port.HasRoom(sendClass, Now))
            {
                _copiesHeldBack++;
                continue;
            }

            port.TakeRate(frame);
            sent |= link;
        }

        if (sent != 0)
            SendOwn(sent, frame, crcExtra);
    }

    private LinkRoom RoomTowards(byte system, VehicleMessageClass messageClass)
    {
        ulong links = system == 0 ? ulong.MaxValue : _router.LinksOf(system, 0);
        SendClass sendClass = SendClasses.Of(messageClass);
        (ulong wanted, ulong free, TimeSpan? wait) = (0, 0, null);
        foreach (LinkPort port in _ports)
        {
            ulong link = 1UL << port.Number;
            if ((links & link) == 0 || !port.IsSending)
                continue;
            wanted |= link;
            if (port.HasRoom(sendClass, Now))
                free |= link;
            else if (port.TimeToRoom(Now) is var next && !(next >= wait))
                wait = next;
        }

        return new LinkRoom(wanted, free) { Wait = wait ?? (wanted == 0 ? NoLinkDelay : TimeSpan.Zero) };
    }

    /// <returns>Whether it is part of the exchange, which does not concern the autopilot.</returns>
    private bool TakeVehicleMessage(in LinkFrame frame)
    {
        MavlinkFrame mavlink = frame.Frame;
        if (_exchange is not { } exchange || mavlink.MessageId != Tunnel.MavlinkId)
            return false;
        mavlink.TryDecode(out Tunnel tunnel);
        if ((int)tunnel.PayloadType != ExchangeWire.PayloadType)
            return false;

        // A length above the longest is malformed, as no bytes at all are.
        Span<byte> payload = stackalloc byte[ExchangeWire.MaxLength];
        tunnel.Payload.CopyTo(payload);
        int length = tunnel.PayloadLength <= ExchangeWire.MaxLength ? tunnel.PayloadLength : 0;
        exchange.Take(payload.Slice(0, length), mavlink.SystemId, frame.Time);
        _exchangeDue = TimeSpan.Zero;
        return true;
    }

    private void PostVehicleMessages()
    {
        if (_exchange is not { } exchange)
            return;
        VehicleExchangeCounters counters = exchange.Counters;
        counters.CopiesHeldBack += _copiesHeldBack;
        _vehicleMessageStatus!.Value = new VehicleMessageStatus
        {
            Vehicles = exchange.CountVehicles(Now),
            Waiting = exchange.Waiting,
            TimeAccuracy = exchange.TryGetGpsTime(Now, out _, out TimeSpan accuracy) ? accuracy : null,
            Counters = counters,
        };
        _vehicleMessageStatus.Post();
    }

    private void EndVehicleMessages()
    {
        if (_exchange is not { } exchange)
            return;
        foreach (VehicleMessageChannel channel in _channels)
            channel.Post(exchange, Now);
        exchange.EndAll();
        TakeFrom(exchange);
    }
}
