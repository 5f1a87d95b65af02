using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

// What comes in: fragments are put together, acknowledged and handed on once; what others are to have is relayed.
internal sealed partial class MessageExchange
{
    // Messages that are put together at a time, and all that are remembered.
    private const int MaxIncomplete = 32;
    private const int MaxIncoming = 1024;

    // Fragments come in a row: one acknowledgement answers several.
    private static readonly TimeSpan AcknowledgementDelay = TimeSpan.FromTicks(60 * TimeSpan.TicksPerMillisecond);

    private readonly Dictionary<ulong, IncomingExchange> _incoming = [];
    private readonly List<ulong> _forgotten = [];
    private readonly Queue<ReceivedExchangeMessage> _received = new();
    private TimeSpan _nextForgetting;
    private int _incomplete;

    /// <summary>Takes what came in.</summary>
    /// <param name="datagram">The payload of a TUNNEL of our family.</param>
    /// <param name="senderSystemId">Whose frame it was.</param>
    /// <param name="now">The time.</param>
    public void Take(ReadOnlySpan<byte> datagram, byte senderSystemId, TimeSpan now)
    {
        bool isTaken = ExchangeWire.KindOf(datagram) switch
        {
            ExchangeKind.Fragment => TakeFragment(datagram, senderSystemId, now),
            ExchangeKind.Acknowledgement => TakeAcknowledgement(datagram, senderSystemId, now),
            ExchangeKind.Announcement => TakeAnnouncement(datagram, senderSystemId, now),
            _ => false,
        };
        if (!isTaken)
            _counters.Malformed++;
    }

    /// <summary>Gives the next message that is whole; false where there is none.</summary>
    public bool TryReceive(out ReceivedExchangeMessage? message)
    {
        message = _received.Count > 0 ? _received.Dequeue() : null;
        return message is not null;
    }

    private bool TakeFragment(ReadOnlySpan<byte> datagram, byte sender, TimeSpan now)
    {
        if (!ExchangeWire.TryRead(datagram, out ExchangeFragment fragment)
            || !IsFrom(fragment.Source, fragment.Hops, sender))
            return false;
        if (fragment.Source == SystemId)
        {
            _counters.Echoes++;
            return true;
        }

        bool isOnlyForUs = fragment.Destination == new VehicleDestination(VehicleDestination.Kind.Vehicle, SystemId);
        if (!isOnlyForUs)
            Relay(datagram, fragment.Hops, ExchangeKind.Fragment, fragment.Class, KeyOf(fragment), now);
        return !IsForUs(fragment.Destination) || TakeFragmentForUs(datagram, fragment, now);
    }

    private bool TakeFragmentForUs(ReadOnlySpan<byte> datagram, in ExchangeFragment fragment, TimeSpan now)
    {
        ulong key = ((ulong)fragment.Source << 32) | fragment.Id;
        if (!_incoming.TryGetValue(key, out IncomingExchange? incoming))
        {
            if (fragment.LifetimeMs == 0)
                return true;
            incoming = Begin(key, fragment, now);
        }
        else if (!incoming.Fits(fragment))
        {
            return false;
        }

        bool isNew = !incoming.IsOver
            && incoming.Add(fragment.Index, datagram.Slice(ExchangeWire.HeaderLength));
        incoming.IsRelayed |= isNew && ExchangeWire.IsRelayed(fragment.Hops);
        if (isNew)
            incoming.NoteAge(fragment.AgeMs, now);
        if (!isNew)
            _counters.Duplicates++;
        else if (incoming.IsWhole)
            Finish(incoming, now);
        if (fragment.IsAcknowledged)
            incoming.AcknowledgementDue ??= incoming.IsOver ? now : now + AcknowledgementDelay;
        if (fragment.IsAcknowledged && incoming.IsOver && incoming.AcknowledgementDue > now)
            incoming.AcknowledgementDue = now;
        return true;
    }

    private IncomingExchange Begin(ulong key, in ExchangeFragment fragment, TimeSpan now)
    {
        if (_incomplete >= MaxIncomplete || _incoming.Count >= MaxIncoming)
            MakeRoom(now);
        var incoming = new IncomingExchange(fragment, now);
        _incoming.Add(key, incoming);
        if (_types.TryGetValue(fragment.Type, out byte newest) && fragment.TypeVersion <= newest)
        {
            _incomplete++;
            return incoming;
        }

        _counters.NotUnderstood++;
        incoming.IsUnderstood = false;
        incoming.End();
        return incoming;
    }

    private void Finish(IncomingExchange incoming, TimeSpan now)
    {
        ExchangeFragment header = incoming.Header;
        _incomplete--;
        byte[] content = incoming.TakeContent();
        _counters.Delivered++;
        _received.Enqueue(new ReceivedExchangeMessage
        {
            SourceSystemId = header.Source,
            Id = header.Id,
            Type = header.Type,
            Version = header.TypeVersion,
            Content = content,
            Destination = header.Destination,
            Class = header.Class,
            ReceivedTime = now,
            PostedTime = incoming.PostedTime,
            SentUtcMicroseconds = header.SentUtcMicroseconds,
            TimeAccuracy = ExchangeWire.AccuracyOf(header.Accuracy),
            IsRelayed = incoming.IsRelayed,
        });
    }

    private bool TakeAcknowledgement(ReadOnlySpan<byte> datagram, byte sender, TimeSpan now)
    {
        if (!ExchangeWire.TryRead(datagram, out ExchangeAcknowledgement answer)
            || !IsFrom(answer.Source, answer.Hops, sender))
            return false;
        if (answer.Source == SystemId)
        {
            _counters.Echoes++;
            return true;
        }

        if (answer.Destination != SystemId)
        {
            long key = Mix(
                ((long)answer.Source << 40) | ((long)answer.Destination << 32) | answer.Id, answer.Fragments);
            Relay(datagram, answer.Hops, ExchangeKind.Acknowledgement, VehicleMessageClass.Command, key, now);
            return true;
        }

        foreach (OutgoingExchange outgoing in _outgoing)
        {
            if (outgoing.Id == answer.Id)
                outgoing.Take(answer, now, _roundTrip);
        }

        EndThoseThatAreOver(now);
        return true;
    }

    private bool TakeAnnouncement(ReadOnlySpan<byte> datagram, byte sender, TimeSpan now)
    {
        if (!ExchangeWire.TryRead(datagram, out ExchangeAnnouncement announcement)
            || !IsFrom(announcement.Source, announcement.Hops, sender))
            return false;
        if (announcement.Source == SystemId)
        {
            _counters.Echoes++;
            return true;
        }

        // Who is new receives ours soon.
        if (_peers.Take(announcement, now))
            AnnounceSoon(now);
        long key = Mix(
            ((long)announcement.Source << 32) | ((uint)announcement.Session << 16) | announcement.Number, 1);
        Relay(
            datagram, announcement.Hops, ExchangeKind.Announcement, VehicleMessageClass.Coordination, key, now);
        return true;
    }

    // What comes at first hand says itself whose it is.
    private static bool IsFrom(byte source, byte hops, byte sender) => ExchangeWire.IsRelayed(hops) || source == sender;

    private bool IsForUs(VehicleDestination destination) => destination.To switch
    {
        VehicleDestination.Kind.Vehicle => destination.Number == SystemId,
        VehicleDestination.Kind.Group => (_groups & (1u << destination.Number)) != 0,
        _ => true,
    };

    private void Relay(
        ReadOnlySpan<byte> datagram, byte hops, ExchangeKind kind, VehicleMessageClass messageClass, long key,
        TimeSpan now)
    {
        int left = ExchangeWire.HopsLeft(hops);
        if (_options.Relays && left > 0)
            _relay.Add(key, datagram, (byte)(hops - 1), kind, messageClass, now);
    }

    private bool TryAcknowledge(TimeSpan now, Span<byte> to, out ExchangeDatagram datagram)
    {
        datagram = default;
        foreach (IncomingExchange incoming in _incoming.Values)
        {
            int limit = incoming.Header.Hops >> 4;
            bool isDue = incoming.AcknowledgementDue <= now && RoomForAnswer(incoming).Free != 0;
            if (!isDue)
                continue;
            incoming.AcknowledgementDue = null;
            var answer = new ExchangeAcknowledgement
            {
                Source = SystemId,
                Destination = incoming.Header.Source,
                Id = incoming.Header.Id,
                IsUnderstood = incoming.IsUnderstood,
                Hops = ExchangeWire.Hops(limit, limit),
                Fragments = incoming.Fragments,
            };
            datagram = new ExchangeDatagram
            {
                Length = ExchangeWire.Write(to, answer),
                TargetSystem = limit == 0 ? answer.Destination : (byte)0,
                Class = VehicleMessageClass.Command,
            };
            _counters.AcknowledgementsSent++;
            return true;
        }

        return false;
    }

    private void ForgetReceived(TimeSpan now)
    {
        if (now < _nextForgetting)
            return;
        _nextForgetting = now + TimeSpan.FromSeconds(1);
        _forgotten.Clear();
        foreach (KeyValuePair<ulong, IncomingExchange> entry in _incoming)
        {
            IncomingExchange incoming = entry.Value;
            if (!incoming.IsOver && incoming.Deadline <= now)
                GiveUp(incoming);
            if (incoming.ForgottenAt <= now)
                _forgotten.Add(entry.Key);
        }

        foreach (ulong key in _forgotten)
            _incoming.Remove(key);
    }

    // The one that has least time left goes: of those that are not whole where they are too many, else of all.
    private void MakeRoom(TimeSpan now)
    {
        _nextForgetting = now;
        ForgetReceived(now);
        bool isOfIncomplete = _incomplete >= MaxIncomplete;
        if (!isOfIncomplete && _incoming.Count < MaxIncoming)
            return;
        ulong first = 0;
        IncomingExchange? least = null;
        foreach (KeyValuePair<ulong, IncomingExchange> entry in _incoming)
        {
            bool isCandidate = !isOfIncomplete || !entry.Value.IsOver;
            if (isCandidate && (least is null || entry.Value.Deadline < least.Deadline))
                (first, least) = (entry.Key, entry.Value);
        }

        if (least is null)
            return;
        if (!least.IsOver)
            GiveUp(least);
        if (_incoming.Count >= MaxIncoming)
            _incoming.Remove(first);
    }

    private void GiveUp(IncomingExchange incoming)
    {
        _incomplete--;
        _counters.Incomplete++;
        incoming.AcknowledgementDue = null;
        incoming.End();
    }

    private static long KeyOf(in ExchangeFragment fragment)
        => Mix(((long)fragment.Source << 40) | ((long)fragment.Index << 32) | fragment.Id, 2);

    private static long Mix(long key, uint more) => unchecked((key * 6364136223846793005) ^ (more * 2654435761L));
}
