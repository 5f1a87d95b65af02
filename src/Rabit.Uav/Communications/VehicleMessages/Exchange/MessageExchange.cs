using System;
using System.Collections.Generic;

namespace Rabit.Uav.Communications;

/// <summary>
/// Messages between vehicles over links that lose, repeat and reorder: cut into fragments that fit one TUNNEL,
/// acknowledged fragment by fragment, relayed by others where that is asked for, delivered once. What was to be
/// acknowledged is reported once: delivered, or why not. No I/O; time comes in; one thread.
/// </summary>
internal sealed partial class MessageExchange
{
    private const int MaxOutgoing = 64;

    // Announcements that a peer may miss.
    private const int MissedAnnouncements = 5;

    private static readonly TimeSpan MinPause = TimeSpan.FromTicks(300 * TimeSpan.TicksPerMillisecond);
    private static readonly TimeSpan MaxLifetime = TimeSpan.FromMinutes(10);

    private readonly ExchangeOptions _options;
    private readonly byte _systemId;
    private readonly ushort _session;
    private readonly uint _groups;
    private readonly Dictionary<ushort, byte> _types = [];
    private readonly ExchangePeers _peers = new();
    private readonly ExchangeRelay _relay;
    private readonly GpsTimeBase _time = new();
    private readonly List<OutgoingExchange> _outgoing = [];
    private readonly Queue<DeliveryReport> _reports = new();
    private readonly RoundTripTime _roundTrip = new();
    private ExchangeCounters _counters;
    private TimeSpan? _timeLateBy;
    private TimeSpan _nextAnnouncement;
    private TimeSpan? _lastAnnouncement;
    private ushort _announcements;
    private ushort _numbers;

    /// <param name="options">Checked.</param>
    /// <param name="systemId">Our system id.</param>
    /// <param name="random">The session, which keeps messages of two runs apart, and the waits of relays.</param>
    public MessageExchange(ExchangeOptions options, byte systemId, ExchangeRandom random)
    {
        (_options, _systemId) = (options.Copy(), systemId);
        _session = (ushort)random.Next(65536);
        _groups = _options.GroupBits;
        _relay = new ExchangeRelay(random);
    }

    public ExchangeCounters Counters => _counters;

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
        if (_outgoing.Count == MaxOutgoing)
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

    /// <summary>Gives what became of a message; false where there is nothing new.</summary>
    public bool TryReport(out DeliveryReport report)
    {
        report = default;
        if (_reports.Count == 0)
            return false;
        report = _reports.Dequeue();
        return true;
    }

    /// <summary>GPS time now; false where the autopilot has none.</summary>
    public bool TryGetGpsTime(TimeSpan now, out long utcMicroseconds, out TimeSpan accuracy)
        => _time.TryGet(now, _timeLateBy, out utcMicroseconds, out accuracy);

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
        if (message.HopLimit is < 0 or > ExchangeOptions.MaxHops)
            throw new ArgumentException(
                $"The hop limit of a message between vehicles is 0 to {ExchangeOptions.MaxHops}, not "
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
                && older.Destination == newer.Destination && !_outgoing[i].WasSent;
            if (isReplaced)
                End(i, DeliveryOutcome.Replaced);
        }
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
            if (outgoing.IsDone)
                End(i, outgoing.NotUnderstood > 0 ? DeliveryOutcome.NotUnderstood : DeliveryOutcome.Delivered);
            else if (outgoing.Deadline <= now)
                End(i, DeliveryOutcome.Expired);
        }
    }

    private void End(int index, DeliveryOutcome outcome)
    {
        OutgoingExchange outgoing = _outgoing[index];
        _outgoing.RemoveAt(index);
        if (outcome == DeliveryOutcome.Expired)
            _counters.Expired++;
        Report(outgoing.Message, outcome, outgoing);
    }

    private void Report(ExchangeMessage message, DeliveryOutcome outcome, OutgoingExchange? outgoing = null)
    {
        if (!message.IsAcknowledged)
            return;
        _reports.Enqueue(new DeliveryReport
        {
            Reference = message.Reference,
            Outcome = outcome,
            Receivers = outgoing?.Receivers ?? 0,
            Acknowledged = outgoing?.Acknowledged ?? 0,
            NotUnderstood = outgoing?.NotUnderstood ?? 0,
        });
    }
}
