using System;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Communications;

/// <summary>
/// What goes out next over a link with a budget, and when. It follows the transmitter: what was released is on its way
/// until <c>_freeAt</c>, and nothing but urgent frames is released before that, so that what is urgent never waits for
/// more than one other frame. No I/O; time comes in; one thread; allocates nothing for a frame, but for state of a new
/// kind.
/// </summary>
/// <param name="budget">The budget; checked.</param>
/// <param name="signatureBytes">What the signature adds to a frame of ours.</param>
internal sealed class LinkScheduler(SendBudget budget, int signatureBytes)
{
    // The part of the rate that urgent frames may have ahead of all others; more of them wait like commands, so that a
    // flood of heartbeats does not keep the rest out.
    private const double UrgentShare = 0.25;
    private const double BulkShare = 0.05;
    private const int Classes = (int)SendClass.Bulk + 1;

    // A wake-up comes late by as much, and the link would stand still meanwhile.
    private static readonly TimeSpan Slack = TimeSpan.FromMilliseconds(5);

    // A command that is older was sent again meanwhile (MAVLink guide: after 0.5 to 1.5 s).
    private static readonly TimeSpan[] MaxAges =
    [
        TimeSpan.FromSeconds(2), TimeSpan.FromSeconds(2), TimeSpan.FromSeconds(5), TimeSpan.FromSeconds(5),
        TimeSpan.FromSeconds(30),
    ];

    private readonly FrameFifo _urgent = new(32);
    private readonly FrameFifo _commands = new(64);
    private readonly FrameFifo _coordination = new(64);
    private readonly FrameFifo _bulk = new(256);
    private readonly StateSlots _state = new();
    private readonly TransmitBufferLaw _law = new(budget.RadioBufferLaw);
    private readonly RoundTripLaw _roundTrip = new();
    private readonly SendCounters[] _counters = new SendCounters[Classes];
    private TimeSpan _freeAt;
    private TimeSpan _tokensAt;
    private double _urgentTokens = budget.BurstBytes;
    private double _bulkCredit;
    private long _bytesOut;

    public double BytesPerSecond { get; private set; } = budget.BytesPerSecond;

    /// <summary>What measures the round trip; null where the rate does not follow it.</summary>
    public RoundTripProbe? Probe { get; } = budget.FollowsRoundTripTime ? new RoundTripProbe() : null;

    /// <summary>Frames that waited too long, or for which there was no room.</summary>
    public long Dropped
    {
        get
        {
            long dropped = 0;
            foreach (SendCounters counters in _counters)
                dropped += counters.Expired + counters.Full;
            return dropped;
        }
    }

    private int Waiting => _urgent.Count + _commands.Count + _coordination.Count + _bulk.Count + _state.Pending;

    /// <summary>Takes the state of the radio's buffer.</summary>
    public void NoteRadioBuffer(byte freePercent, TimeSpan now)
    {
        if (budget.FollowsRadioBuffer)
            _law.Note(freePercent, now);
        FollowLaws(now);
    }

    /// <summary>Takes an answer to a request of <see cref="Probe"/>.</summary>
    public void TakePing(in Ping answer, TimeSpan now)
    {
        if (Probe?.TryTake(answer, now, out TimeSpan roundTrip) == true)
            _roundTrip.Note(roundTrip, now);
        FollowLaws(now);
    }

    /// <summary>Takes a frame that is to be sent.</summary>
    /// <param name="frame">The frame; a ValidUntil of zero is that of its class.</param>
    /// <param name="sendClass">Its class.</param>
    /// <param name="now">The time.</param>
    public void Put(FrameToSend frame, SendClass sendClass, TimeSpan now)
    {
        TimeSpan latest = now + MaxAges[(int)sendClass];
        if (frame.ValidUntil == TimeSpan.Zero || frame.ValidUntil > latest)
            frame.ValidUntil = latest;
        ref SendCounters counters = ref _counters[(int)sendClass];
        if (sendClass != SendClass.State)
        {
            if (!FifoOf(sendClass).Add(frame))
                counters.Full++;
            return;
        }

        SlotResult result = _state.Put(SendClasses.KeyOf(frame.Frame), frame, now);
        if (result == SlotResult.Replaced)
            counters.Replaced++;
        else if (result == SlotResult.NoRoom)
            counters.Full++;
    }

    /// <summary>Gives the frame that is to go out now.</summary>
    /// <returns>False where nothing may: nothing waits, or the link is not free yet.</returns>
    public bool TryTake(TimeSpan now, out FrameToSend frame)
    {
        RemoveExpired(now);
        FollowLaws(now);
        FillTokens(now);
        if (_urgent.Count > 0 && Length(_urgent.First) <= _urgentTokens)
        {
            _urgentTokens -= Length(_urgent.First);
            return TakeFirst(SendClass.Urgent, now, out frame);
        }

        frame = default;
        if (now < _freeAt)
            return false;
        if (_bulk.Count > 0 && _bulkCredit >= Length(_bulk.First))
            return TakeFirst(SendClass.Bulk, now, out frame);
        if (_commands.Count > 0)
            return TakeFirst(SendClass.Commands, now, out frame);
        if (_urgent.Count > 0)
            return TakeFirst(SendClass.Urgent, now, out frame);
        if (_coordination.Count > 0)
            return TakeFirst(SendClass.Coordination, now, out frame);
        if (TakeState(now, out frame))
            return true;
        return _bulk.Count > 0 && TakeFirst(SendClass.Bulk, now, out frame);
    }

    /// <summary>What may not be left behind at the end, whatever the budget: urgent frames and commands.</summary>
    public bool TryTakeAtTheEnd(TimeSpan now, out FrameToSend frame)
    {
        frame = default;
        return (_urgent.Count > 0 && TakeFirst(SendClass.Urgent, now, out frame))
            || (_commands.Count > 0 && TakeFirst(SendClass.Commands, now, out frame));
    }

    /// <summary>How long until <see cref="TryTake"/> may give a frame; null where none waits.</summary>
    public TimeSpan? TimeToNext(TimeSpan now)
    {
        if (Waiting == 0)
            return null;
        TimeSpan wait = _freeAt - now;
        return wait > TimeSpan.Zero ? wait : TimeSpan.Zero;
    }

    /// <summary>How many frames of a class wait; not of state, which is no queue.</summary>
    public int WaitingOf(SendClass sendClass) => FifoOf(sendClass).Count;

    public LinkBudgetStatus Status(TimeSpan now) => new()
    {
        BytesPerSecond = BytesPerSecond,
        BytesOut = _bytesOut,
        Waiting = Waiting,
        RoundTripSeconds = _roundTrip.RoundTrip.ExactSeconds,
        GrantedShare = _state.GrantedShare(now),
        Urgent = _counters[(int)SendClass.Urgent],
        Commands = _counters[(int)SendClass.Commands],
        Coordination = _counters[(int)SendClass.Coordination],
        State = _counters[(int)SendClass.State],
        Bulk = _counters[(int)SendClass.Bulk],
    };

    private void FollowLaws(TimeSpan now)
        => BytesPerSecond = budget.BytesPerSecond * Math.Min(_law.FactorAt(now), _roundTrip.FactorAt(now));

    private FrameFifo FifoOf(SendClass sendClass) => sendClass switch
    {
        SendClass.Urgent => _urgent,
        SendClass.Commands => _commands,
        SendClass.Coordination => _coordination,
        _ => _bulk,
    };

    private int Length(in FrameToSend frame) => frame.Frame.WireLength + (frame.IsOwn ? signatureBytes : 0);

    private bool TakeFirst(SendClass sendClass, TimeSpan now, out FrameToSend frame)
    {
        FrameFifo fifo = FifoOf(sendClass);
        frame = fifo.First;
        fifo.RemoveFirst();
        Charge(frame, sendClass, now);
        return true;
    }

    private bool TakeState(TimeSpan now, out FrameToSend frame)
    {
        if (!_state.TryPeek(out ulong key, out frame))
            return false;
        _state.MarkSent(key, now);
        Charge(frame, SendClass.State, now);
        return true;
    }

    private void Charge(in FrameToSend frame, SendClass sendClass, TimeSpan now)
    {
        int length = Length(frame);
        TimeSpan start = _freeAt > now - Slack ? _freeAt : now - Slack;
        _freeAt = start + TimeSpan.FromTicks((long)(length / BytesPerSecond * TimeSpan.TicksPerSecond));
        _bytesOut += length;
        _counters[(int)sendClass].Sent++;

        // What bulk is owed grows only while it waits.
        _bulkCredit = sendClass == SendClass.Bulk ? Math.Max(0, _bulkCredit - length)
            : _bulk.Count == 0 ? 0
            : Math.Min(MavlinkFrame.MaxWireLength, _bulkCredit + (BulkShare / (1 - BulkShare) * length));
    }

    private void FillTokens(TimeSpan now)
    {
        double filled = (now - _tokensAt).ExactSeconds * UrgentShare * BytesPerSecond;
        (_urgentTokens, _tokensAt) = (Math.Min(budget.BurstBytes, _urgentTokens + filled), now);
    }

    private void RemoveExpired(TimeSpan now)
    {
        _counters[(int)SendClass.Urgent].Expired += _urgent.RemoveExpired(now);
        _counters[(int)SendClass.Commands].Expired += _commands.RemoveExpired(now);
        _counters[(int)SendClass.Coordination].Expired += _coordination.RemoveExpired(now);
        _counters[(int)SendClass.Bulk].Expired += _bulk.RemoveExpired(now);
        _counters[(int)SendClass.State].Expired += _state.RemoveExpired(now);
    }
}
