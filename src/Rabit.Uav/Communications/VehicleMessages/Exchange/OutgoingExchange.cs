using System;
using System.Collections.Generic;

namespace Rabit.Uav.Communications;

/// <summary>A message of ours on its way: who has which of its fragments. One thread.</summary>
internal sealed class OutgoingExchange
{
    // Fragments that may be on their way unanswered.
    private const int Window = 8;

    private readonly Dictionary<byte, uint> _answers = [];
    private readonly TimeSpan?[] _sentAt;
    private readonly int[] _tries;

    // The links that each fragment went over: a copy of what is not acknowledged is not sent again.
    private readonly ulong[] _carried;

    /// <param name="message">The message.</param>
    /// <param name="id">Its id.</param>
    /// <param name="receivers">Who must acknowledge it; empty where none must.</param>
    /// <param name="now">When it was posted.</param>
    public OutgoingExchange(ExchangeMessage message, uint id, IEnumerable<byte> receivers, TimeSpan now)
    {
        (Message, Id) = (message, id);
        (PostedAt, Deadline) = (now, now + message.Lifetime);
        Count = Math.Max(
            1, (message.Content.Length + ExchangeWire.FragmentLength - 1) / ExchangeWire.FragmentLength);
        _sentAt = new TimeSpan?[Count];
        _tries = new int[Count];
        _carried = new ulong[Count];
        foreach (byte receiver in receivers)
            _answers[receiver] = 0;
    }

    public ExchangeMessage Message { get; }

    public uint Id { get; }

    public TimeSpan PostedAt { get; }

    public TimeSpan Deadline { get; }

    public int Count { get; }

    /// <summary>By GPS; 0 where we have no such time.</summary>
    public long SentUtcMicroseconds { get; init; }

    public byte Accuracy { get; init; }

    public int NotUnderstood { get; private set; }

    public int Receivers => _answers.Count;

    public int Acknowledged
    {
        get
        {
            int acknowledged = 0;
            foreach (KeyValuePair<byte, uint> answer in _answers)
            {
                if (answer.Value == All)
                    acknowledged++;
            }

            return acknowledged - NotUnderstood;
        }
    }

    public bool WasSent => Array.Exists(_sentAt, t => t is not null);

    /// <summary>Whether all of it went out over some link, of what is not acknowledged.</summary>
    public bool IsSent => !Message.IsAcknowledged && Array.TrueForAll(_sentAt, t => t is not null);

    private uint All => Count == 32 ? uint.MaxValue : (1u << Count) - 1;

    /// <summary>Whether there is nothing more to do: all have answered, or it was sent and none must.</summary>
    public bool IsDone(LinkRoom room)
    {
        if (Message.IsAcknowledged)
            return Acknowledged + NotUnderstood == Receivers;
        foreach (ulong carried in _carried)
        {
            if (!room.IsCarried(carried))
                return false;
        }

        return true;
    }

    /// <summary>Over how many links a part of it did not go.</summary>
    public int LinksMissed(LinkRoom room)
    {
        ulong all = ulong.MaxValue;
        foreach (ulong carried in _carried)
            all &= carried;
        return room.Missed(all);
    }

    /// <summary>Whether a fragment went over another link, and is only copied to more of them.</summary>
    public bool IsCopy(int fragment) => !Message.IsAcknowledged && _carried[fragment] != 0;

    /// <summary>The links that a fragment is to go over now; 0 for all with room.</summary>
    public ulong LinksFor(int fragment, LinkRoom room) => Message.IsAcknowledged ? 0 : room.Left(_carried[fragment]);

    /// <summary>The next fragment that is due.</summary>
    /// <returns>False where none is before <paramref name="due"/>.</returns>
    public bool TryNext(
        TimeSpan now, RoundTripTime roundTrip, LinkRoom room, out int fragment, out TimeSpan due)
    {
        if (!Message.IsAcknowledged)
        {
            due = IsDone(room) ? TimeSpan.MaxValue : now;
            for (fragment = 0; fragment < Count; fragment++)
            {
                if (room.Left(_carried[fragment]) != 0)
                    return true;
            }

            return false;
        }

        return TryNext(now, roundTrip, out fragment, out due);
    }

    private bool TryNext(TimeSpan now, RoundTripTime roundTrip, out int fragment, out TimeSpan due)
    {
        due = TimeSpan.MaxValue;
        uint missing = Missing();
        int waiting = 0;
        for (fragment = 0; fragment < Count; fragment++)
        {
            if ((missing & (1u << fragment)) == 0)
                continue;
            if (_sentAt[fragment] is not { } sent)
            {
                if (waiting >= Window)
                    break;
                due = now;
                return true;
            }

            TimeSpan again = sent + roundTrip.TimeOut(_tries[fragment]);
            if (again <= now)
            {
                due = now;
                return true;
            }

            waiting++;
            if (again < due)
                due = again;
        }

        return false;
    }

    /// <returns>Whether it was sent before.</returns>
    public bool MarkSent(int fragment, LinkRoom room, TimeSpan now)
    {
        _sentAt[fragment] = now;
        _carried[fragment] |= room.Free;
        return ++_tries[fragment] > 1 && Message.IsAcknowledged;
    }

    /// <summary>Takes what a receiver has.</summary>
    public void Take(in ExchangeAcknowledgement answer, TimeSpan now, RoundTripTime roundTrip)
    {
        if (!_answers.TryGetValue(answer.Source, out uint before) || before == All)
            return;
        if (!answer.IsUnderstood)
        {
            _answers[answer.Source] = All;
            NotUnderstood++;
            return;
        }

        uint has = before | (answer.Fragments & All);
        _answers[answer.Source] = has;
        Measure(has & ~before, now, roundTrip);
        SendGapsAgain(has, now, roundTrip);
    }

    // By the newest one, and only what was sent once: of others it is not known which copy was answered (Karn).
    private void Measure(uint fresh, TimeSpan now, RoundTripTime roundTrip)
    {
        TimeSpan? newest = null;
        for (int fragment = 0; fragment < Count; fragment++)
        {
            bool isMeasure = (fresh & (1u << fragment)) != 0 && _tries[fragment] == 1;
            if (isMeasure && !(newest >= _sentAt[fragment]))
                newest = _sentAt[fragment];
        }

        if (newest is { } sent)
            roundTrip.Note(now - sent);
    }

    // What is missing before the last that came was lost, unless it was sent so lately that it may still come.
    private void SendGapsAgain(uint has, TimeSpan now, RoundTripTime roundTrip)
    {
        for (int fragment = 0; fragment < Count && has >> fragment != 0; fragment++)
        {
            bool isGap = (has & (1u << fragment)) == 0;
            if (isGap && _sentAt[fragment] is { } sent && now - sent > roundTrip.Mean)
                _sentAt[fragment] = now - TimeSpan.FromMinutes(1);
        }
    }

    private uint Missing()
    {
        uint missing = 0;
        foreach (KeyValuePair<byte, uint> answer in _answers)
            missing |= All & ~answer.Value;
        return missing;
    }
}
