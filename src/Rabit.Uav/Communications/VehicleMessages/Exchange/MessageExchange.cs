using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// Messages between vehicles over links that lose, repeat and reorder: cut into fragments that fit one TUNNEL,
/// acknowledged fragment by fragment, relayed by others where that is asked for, delivered once. What was to be
/// acknowledged is reported once: delivered, or why not. No I/O; time comes in; one thread.
/// </summary>
internal sealed partial class MessageExchange
{
    public static readonly TimeSpan MaxLifetime = TimeSpan.FromMinutes(10);

    private const int MaxOutgoing = 256;

    // Announcements that a peer may miss.
    private const int MissedAnnouncements = 5;

    // Of one datagram; waits at relays are counted in its age.
    private static readonly TimeSpan MaxTimeOnTheWay = TimeSpan.FromSeconds(10);

    private static readonly TimeSpan MinPause = TimeSpan.FromTicks(300 * TimeSpan.TicksPerMillisecond);

    private readonly VehicleExchangeOptions _options;
    private readonly ushort _session;
    private readonly uint _groups;
    private readonly Dictionary<ushort, byte> _types = [];
    private readonly ExchangePeers _peers = new();
    private readonly ExchangeRelay _relay;
    private readonly ExchangeRandom _random;
    private readonly GpsTimeBase _time = new();
    private readonly List<OutgoingExchange> _outgoing = [];
    private readonly Queue<(ExchangeMessage Message, DeliveryReport Report)> _reports = new();
    private readonly Func<byte, VehicleMessageClass, LinkRoom>? _room;
    private readonly bool _announces;
    private readonly RoundTripTime _roundTrip = new();
    private VehicleExchangeCounters _counters;
    private TimeSpan? _timeLateBy;
    private TimeSpan _nextAnnouncement;
    private TimeSpan? _lastAnnouncement;
    private ExchangeAnnouncement _announcement; // the last one
    private ulong _announcedOver; // the links that it went over
    private ushort _announcements;
    private ushort _numbers;
    private byte _systemId;

    /// <param name="options">Checked.</param>
    /// <param name="systemId">Our system id; 0 where it is not known yet: nothing is sent before.</param>
    /// <param name="random">The session, which keeps messages of two runs apart, and the waits of relays.</param>
    /// <param name="room">
    /// Over which links a datagram of a class to a system, 0 for all, goes now; without it one link that has room.
    /// </param>
    public MessageExchange(
        VehicleExchangeOptions options, byte systemId, ExchangeRandom random,
        Func<byte, VehicleMessageClass, LinkRoom>? room = null)
    {
        (_options, _systemId, _room, _random) = (options.Copy(), systemId, room, random);
        _announces = options.Announces != false;
        _session = (ushort)random.Next(65536);
        _groups = _options.GroupBits;
        _relay = new ExchangeRelay(random, messageClass => Room(0, messageClass));
    }

    /// <summary>Our system id; 0 where it is not known yet.</summary>
    public byte SystemId
    {
        get => _systemId;
        set
        {
            if (value == _systemId)
                return;
            _random.Stir(value);
            _systemId = value;
            DropAnnouncement();
        }
    }

    public VehicleExchangeCounters Counters
    {
        get
        {
            VehicleExchangeCounters counters = _counters;
            counters.CopiesHeldBack += _relay.CopiesHeldBack;
            return counters;
        }
    }

    /// <summary>Messages of ours that are not over.</summary>
    public int Waiting => _outgoing.Count;

    /// <summary>Vehicles that were received lately.</summary>
    public int CountVehicles(TimeSpan now) => _peers.Count(now - Memory);

    /// <summary>Says that a type is understood, up to a version.</summary>
    public void Understand(ushort type, byte newestVersion) => _types[type] = newestVersion;

    /// <summary>Takes GPS time from the autopilot.</summary>
    /// <param name="utcMicroseconds">Microseconds since 1970 UTC.</param>
    /// <param name="time">When that was true, by the clock of the run.</param>
    /// <param name="lateBy">How late it may be; null for not known.</param>
    public void NoteGpsTime(long utcMicroseconds, TimeSpan time, TimeSpan? lateBy)
    {
        _timeLateBy = lateBy;
        _time.Note(utcMicroseconds, time);
    }

    /// <summary>Takes a message that is to be sent.</summary>
    /// <exception cref="ArgumentException">It is too long, or lives too long, or may go too far.</exception>
    public void Post(ExchangeMessage message, TimeSpan now)
    {
        Check(message);
        _counters.Posted++;
        if (message.Class == VehicleMessageClass.State)
            ReplaceOlder(message);
        if (_outgoing.Count == MaxOutgoing && !MakeRoomFor(message))
        {
            Report(message, DeliveryOutcome.NoRoom);
            return;
        }

        IEnumerable<byte> receivers = !message.IsAcknowledged ? []
            : message.Destination.To == VehicleDestination.Kind.Vehicle ? [message.Destination.Number]
            : _peers.Of(message.Destination, now - Memory);
        bool isDated = TryGetGpsTime(now, out long utc, out TimeSpan accuracy);
        var outgoing = new OutgoingExchange(
            message, ((uint)_session << 16) | unchecked(++_numbers), receivers, now)
        {
            SentUtcMicroseconds = utc,
            Accuracy = ExchangeWire.AccuracyByte(isDated ? accuracy : null),
        };
        if (message.IsAcknowledged && outgoing.Receivers == 0)
            Report(message, DeliveryOutcome.NoReceiver);
        else
            Insert(outgoing);
    }

    /// <summary>Ends all messages of ours that are not over: the run is.</summary>
    public void EndAll()
    {
        for (int i = _outgoing.Count - 1; i >= 0; i--)
            End(i, DeliveryOutcome.Expired);
    }

    /// <summary>Gives what became of a message; false where there is nothing new.</summary>
    public bool TryReport(out ExchangeMessage? message, out DeliveryReport report)
    {
        (message, report) = _reports.Count > 0 ? _reports.Dequeue() : default;
        return message is not null;
    }

    /// <summary>GPS time now; false where the autopilot has none.</summary>
    public bool TryGetGpsTime(TimeSpan now, out long utcMicroseconds, out TimeSpan accuracy)
        => _time.TryGet(now, _timeLateBy, out utcMicroseconds, out accuracy);

    /// <summary>When a message was sent, by the clock of the run here.</summary>
    /// <param name="message">The message.</param>
    /// <param name="now">The time.</param>
    /// <param name="accuracy">
    /// How far that may be off, where both vehicles have GPS time; else null, and it is late by the time on the way.
    /// </param>
    public TimeSpan SentTimeOf(ReceivedExchangeMessage message, TimeSpan now, out TimeSpan? accuracy)
    {
        accuracy = null;
        if (message.TimeAccuracy is not { } theirs || !TryGetGpsTime(now, out long utc, out TimeSpan ours))
            return message.PostedTime;
        const long ticksPerMicrosecond = TimeSpan.TicksPerMillisecond / 1000;
        long sinceMicroseconds = utc - message.SentUtcMicroseconds;
        TimeSpan byGps = now - TimeSpan.FromTicks(sinceMicroseconds * ticksPerMicrosecond);

        // One of the two clocks is wrong.
        if (Math.Abs(sinceMicroseconds) > 1_000_000_000 || (byGps - message.PostedTime).Duration() > MaxTimeOnTheWay)
            return message.PostedTime;
        accuracy = theirs + ours;
        return byGps < message.PostedTime ? byGps : message.PostedTime;
    }

    /// <summary>How good the GPS time of another vehicle is; null where it has none.</summary>
    public TimeSpan? TimeAccuracyOf(byte systemId) => _peers.AccuracyOf(systemId);

    private static void Check(ExchangeMessage message)
    {
        if (message.Content.Length > ExchangeWire.MaxContent)
            throw new ArgumentException(
                $"A message between vehicles has at most {ExchangeWire.MaxContent} bytes, not {message.Content.Length}.",
                nameof(message));
        if (message.Lifetime <= TimeSpan.Zero || message.Lifetime > MaxLifetime)
            throw new ArgumentException(
                $"The lifetime of a message between vehicles is above zero and at most {MaxLifetime}, not "
                    + $"{message.Lifetime}.",
                nameof(message));
        if (message.HopLimit is < 0 or > VehicleExchangeOptions.MaxHops)
            throw new ArgumentException(
                $"The hop limit of a message between vehicles is 0 to {VehicleExchangeOptions.MaxHops}, not "
                    + $"{message.HopLimit}.",
                nameof(message));
    }

    private TimeSpan Memory => TimeSpan.FromTicks(_options.AnnouncementPeriod.Ticks * MissedAnnouncements);

    private void ReplaceOlder(ExchangeMessage newer)
    {
        for (int i = _outgoing.Count - 1; i >= 0; i--)
        {
            ExchangeMessage older = _outgoing[i].Message;
            bool isReplaced = older.Class == VehicleMessageClass.State && older.Type == newer.Type
                && older.Destination == newer.Destination && (!_outgoing[i].WasSent || _outgoing[i].IsSent);
            if (isReplaced)
                End(i, _outgoing[i].WasSent ? DeliveryOutcome.Sent : DeliveryOutcome.Replaced);
        }
    }

    // The newest of those that are least urgent goes, if that is less than the new one.
    private bool MakeRoomFor(ExchangeMessage message)
    {
        int last = _outgoing.Count - 1;
        if (_outgoing[last].Message.Class <= message.Class)
            return false;
        End(last, DeliveryOutcome.NoRoom);
        return true;
    }

    // In the order in which they go out: by class, then as they came.
    private void Insert(OutgoingExchange outgoing)
    {
        int place = _outgoing.Count;
        while (place > 0 && _outgoing[place - 1].Message.Class > outgoing.Message.Class)
            place--;
        _outgoing.Insert(place, outgoing);
    }

    private void EndThoseThatAreOver(TimeSpan now)
    {
        for (int i = _outgoing.Count - 1; i >= 0; i--)
        {
            OutgoingExchange outgoing = _outgoing[i];
            if (outgoing.IsDone(RoomFor(outgoing)))
                End(i, !outgoing.Message.IsAcknowledged ? DeliveryOutcome.Sent
                    : outgoing.NotUnderstood > 0 ? DeliveryOutcome.NotUnderstood
                    : DeliveryOutcome.Delivered);
            else if (outgoing.Deadline <= now)
                End(i, outgoing.IsSent ? DeliveryOutcome.Sent : DeliveryOutcome.Expired);
        }
    }

    private void End(int index, DeliveryOutcome outcome)
    {
        OutgoingExchange outgoing = _outgoing[index];
        _outgoing.RemoveAt(index);
        if (outgoing.IsSent)
            _counters.CopiesHeldBack += outgoing.LinksMissed(RoomFor(outgoing));
        if (outcome == DeliveryOutcome.Expired)
            _counters.Expired++;
        Report(outgoing.Message, outcome, outgoing);
    }

    private void Report(ExchangeMessage message, DeliveryOutcome outcome, OutgoingExchange? outgoing = null)
    {
        var report = new DeliveryReport
        {
            Reference = message.Reference,
            Outcome = outcome,
            Receivers = outgoing?.Receivers ?? 0,
            Acknowledged = outgoing?.Acknowledged ?? 0,
            NotUnderstood = outgoing?.NotUnderstood ?? 0,
        };
        _reports.Enqueue((message, report));
    }
}
