using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

// What goes out next: acknowledgements, what is relayed, our own fragments by class, and that we are there.
internal sealed partial class MessageExchange
{
    /// <summary>Gives the next datagram that is due.</summary>
    /// <param name="now">The time.</param>
    /// <param name="to">Where it goes: <see cref="VehicleMessageRoute.MaxLength"/> bytes.</param>
    /// <param name="datagram">Its length, and to whom.</param>
    /// <returns>False where nothing is due.</returns>
    public bool TryNext(TimeSpan now, Span<byte> to, out ExchangeDatagram datagram)
    {
        EndThoseThatAreOver(now);
        ForgetReceived(now);
        datagram = default;
        if (SystemId == 0)
            return false;
        if (TryAcknowledge(now, to, out datagram))
            return true;
        if (_relay.TryTake(now, isCopy: false, to, out datagram))
        {
            _counters.Relayed++;
            return true;
        }

        // What a slow link has not had yet of others must not keep it from what is our own.
        return TrySendFragment(now, to, out datagram) || TryAnnounce(now, to, out datagram)
            || _relay.TryTake(now, isCopy: true, to, out datagram);
    }

    /// <summary>When <see cref="TryNext"/> is to be asked again, if nothing comes in or is posted before.</summary>
    public TimeSpan NextDue(TimeSpan now)
    {
        TimeSpan due = _relay.NextDue(now);
        LinkRoom toAll = Room(0, VehicleMessageClass.Coordination);
        if (_announces)
            due = Earlier(due, NextWithRoom(_nextAnnouncement, now, toAll));
        if (IsAnnouncementMissing(toAll))
            due = Earlier(due, toAll.Left(_announcedOver) != 0 ? now : now + toAll.Wait);
        foreach (OutgoingExchange outgoing in _outgoing)
        {
            LinkRoom room = RoomFor(outgoing);
            bool isReady = outgoing.TryNext(now, _roundTrip, room, out _, out TimeSpan next);
            next = isReady || next > now ? NextWithRoom(next, now, room) : now + room.Wait;
            due = Earlier(Earlier(due, next), outgoing.Deadline);
        }

        foreach (IncomingExchange incoming in _incoming.Values)
        {
            if (incoming.AcknowledgementDue is { } acknowledgement)
                due = Earlier(due, NextWithRoom(acknowledgement, now, RoomForAnswer(incoming)));
        }

        return due;
    }

    // What is due, and no link has room for, waits for that.
    private static TimeSpan NextWithRoom(TimeSpan due, TimeSpan now, LinkRoom room)
        => due <= now && room.Free == 0 ? now + room.Wait : due;

    private bool TrySendFragment(TimeSpan now, Span<byte> to, out ExchangeDatagram datagram)
    {
        int index = 0;
        foreach (OutgoingExchange outgoing in _outgoing)
        {
            LinkRoom room = RoomFor(outgoing);
            if (room.Free == 0 || !outgoing.TryNext(now, _roundTrip, room, out index, out _))
                continue;
            datagram = Write(outgoing, index, now, to);
            datagram.Links = outgoing.LinksFor(index, room);
            if (!outgoing.IsCopy(index))
                _counters.FragmentsSent++;
            if (outgoing.MarkSent(index, room, now))
                _counters.FragmentsResent++;
            return true;
        }

        datagram = default;
        return false;
    }

    private ExchangeDatagram Write(OutgoingExchange outgoing, int index, TimeSpan now, Span<byte> to)
    {
        ExchangeMessage message = outgoing.Message;
        var header = new ExchangeFragment
        {
            Source = SystemId,
            Destination = message.Destination,
            Id = outgoing.Id,
            Type = message.Type,
            TypeVersion = message.Version,
            Class = message.Class,
            IsAcknowledged = message.IsAcknowledged,
            Hops = ExchangeWire.Hops(message.HopLimit, message.HopLimit),
            Index = (byte)index,
            Count = (byte)outgoing.Count,
            Accuracy = outgoing.Accuracy,
            LifetimeMs = (int)Math.Max(1, (outgoing.Deadline - now).ExactMilliseconds),
            AgeMs = (int)Math.Round((now - outgoing.PostedAt).ExactMilliseconds),
            SentUtcMicroseconds = outgoing.SentUtcMicroseconds,
        };
        int start = index * ExchangeWire.FragmentLength;
        int length = Math.Min(ExchangeWire.FragmentLength, message.Content.Length - start);
        return new ExchangeDatagram
        {
            Length = ExchangeWire.Write(to, header, message.Content.AsSpan(start, length)),
            TargetSystem = TargetOf(message),
            Class = message.Class,
        };
    }

    // What others are to send on they must get.
    private static byte TargetOf(ExchangeMessage message)
        => message.Destination.To == VehicleDestination.Kind.Vehicle && message.HopLimit == 0
            ? message.Destination.Number
            : (byte)0;

    // An answer to what may have been relayed goes to all, to be relayed too.
    private LinkRoom RoomForAnswer(IncomingExchange incoming)
        => Room(incoming.Header.Hops >> 4 == 0 ? incoming.Header.Source : (byte)0, VehicleMessageClass.Command);

    private LinkRoom Room(byte targetSystem, VehicleMessageClass messageClass)
        => _room is null ? LinkRoom.Always : _room(targetSystem, messageClass);

    private LinkRoom RoomFor(OutgoingExchange outgoing) => Room(TargetOf(outgoing.Message), outgoing.Message.Class);

    // Many that start together would else answer each other at once, again and again.
    private void AnnounceSoon(TimeSpan now)
    {
        TimeSpan soon = _lastAnnouncement is { } last ? last + MinPause : now;
        _nextAnnouncement = Earlier(_nextAnnouncement, soon > now ? soon : now);
    }

    // The last announcement was of another vehicle: no link is to get that any more.
    private void DropAnnouncement()
    {
        if (_lastAnnouncement is not null)
            _counters.CopiesHeldBack += Room(0, VehicleMessageClass.Coordination).Missed(_announcedOver);
        (_lastAnnouncement, _nextAnnouncement) = (null, TimeSpan.Zero);
    }

    private bool TryAnnounce(TimeSpan now, Span<byte> to, out ExchangeDatagram datagram)
    {
        datagram = default;
        if (!_announces)
            return false;
        LinkRoom room = Room(0, VehicleMessageClass.Coordination);
        if (now >= _nextAnnouncement && room.Free != 0)
            Announce(now, room);
        ulong links = room.Left(_announcedOver);
        if (links == 0 || _lastAnnouncement is null)
            return false;
        _announcedOver |= links;
        datagram = new ExchangeDatagram
        {
            Length = ExchangeWire.Write(to, _announcement),
            Class = VehicleMessageClass.Coordination,
            Links = links,
        };
        return true;
    }

    // A link that is open and had no room for it.
    private bool IsAnnouncementMissing(LinkRoom room)
        => _lastAnnouncement is not null && !room.IsCarried(_announcedOver);

    private void Announce(TimeSpan now, LinkRoom room)
    {
        if (_lastAnnouncement is not null)
            _counters.CopiesHeldBack += room.Missed(_announcedOver);
        (_nextAnnouncement, _lastAnnouncement) = (now + _options.AnnouncementPeriod, now);
        _announcedOver = 0;
        bool isDated = TryGetGpsTime(now, out _, out TimeSpan accuracy);
        _announcement = new ExchangeAnnouncement
        {
            Source = SystemId,
            Groups = _groups,
            Accuracy = ExchangeWire.AccuracyByte(isDated ? accuracy : null),
            Number = unchecked(++_announcements),
            Hops = ExchangeWire.Hops(_options.AnnouncementHops, _options.AnnouncementHops),
            Session = _session,
        };
    }

    private static TimeSpan Earlier(TimeSpan left, TimeSpan right) => left < right ? left : right;
}
