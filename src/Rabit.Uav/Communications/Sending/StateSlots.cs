using System;
using System.Collections.Generic;

namespace Rabit.Uav.Communications;

/// <summary>
/// The latest value of each piece of state, never a queue. Where not all can go out the rates of all are reduced by the
/// same factor: start-time fair queueing (Goyal, Vin, Cheng 1996), in which a value costs the period in which its piece
/// is asked for. Allocates only for a piece that is new.
/// </summary>
internal sealed class StateSlots
{
    private const int MaxSlots = 256;

    // How much a new interval counts in the mean ones.
    private const double Weight = 0.125;

    // Of a piece that came once only: a second, as of a heartbeat.
    private const double UnknownPeriodSeconds = 1;
    private static readonly TimeSpan Forgotten = TimeSpan.FromSeconds(30);

    private readonly Dictionary<ulong, Slot> _slots = [];
    private readonly List<ulong> _idle = [];
    private double _virtualSeconds;

    public int Pending { get; private set; }

    /// <summary>Puts a value in its slot.</summary>
    /// <returns>
    /// <see cref="SlotResult.Replaced"/> where one that was not sent yet was there; <see cref="SlotResult.NoRoom"/>
    /// where there are too many pieces.
    /// </returns>
    public SlotResult Put(ulong key, in FrameToSend frame, TimeSpan now)
    {
        if (!_slots.TryGetValue(key, out Slot? slot))
        {
            if (_slots.Count == MaxSlots)
                ForgetIdle(now);
            if (_slots.Count == MaxSlots)
                return SlotResult.NoRoom;
            slot = new Slot { LastPut = now, LastSent = now };
            _slots.Add(key, slot);
        }
        else
        {
            slot.AskedSeconds = Mean(slot.AskedSeconds, now - slot.LastPut);
            slot.LastPut = now;
        }

        bool isReplaced = slot.IsPending;
        (slot.Frame, slot.IsPending) = (frame, true);
        if (isReplaced)
            return SlotResult.Replaced;
        slot.Start = Math.Max(slot.Finish, _virtualSeconds);
        Pending++;
        return SlotResult.Added;
    }

    /// <summary>The value that is next; false where none waits.</summary>
    public bool TryPeek(out ulong key, out FrameToSend frame)
    {
        (key, frame) = (0, default);
        double first = double.PositiveInfinity;
        Slot? next = null;
        foreach (KeyValuePair<ulong, Slot> slot in _slots)
        {
            if (slot.Value.IsPending && slot.Value.Start < first)
                (first, next, key) = (slot.Value.Start, slot.Value, slot.Key);
        }

        if (next is null)
            return false;
        frame = next.Frame;
        return true;
    }

    public void MarkSent(ulong key, TimeSpan now)
    {
        Slot slot = _slots[key];
        slot.GrantedSeconds = Mean(slot.GrantedSeconds, now - slot.LastSent);
        (slot.LastSent, slot.IsPending) = (now, false);
        _virtualSeconds = slot.Start;
        slot.Finish = slot.Start + (slot.AskedSeconds > 0 ? slot.AskedSeconds : UnknownPeriodSeconds);
        Pending--;
    }

    /// <returns>How many values were too old.</returns>
    public int RemoveExpired(TimeSpan now)
    {
        int removed = 0;
        if (Pending == 0)
            return removed;
        foreach (KeyValuePair<ulong, Slot> slot in _slots)
        {
            if (!slot.Value.IsPending || slot.Value.Frame.ValidUntil >= now)
                continue;
            slot.Value.IsPending = false;
            Pending--;
            removed++;
        }

        return removed;
    }

    /// <summary>
    /// The smallest part of its asked rate that a piece of state gets, 0 to 1; 1 where nothing is asked.
    /// </summary>
    public double GrantedShare(TimeSpan now)
    {
        double least = 1;
        foreach (KeyValuePair<ulong, Slot> slot in _slots)
        {
            bool isAlive = now - slot.Value.LastPut < Forgotten && slot.Value.AskedSeconds > 0;
            double granted = Math.Max(slot.Value.GrantedSeconds, (now - slot.Value.LastSent).ExactSeconds);
            if (isAlive && slot.Value.IsPending && granted > slot.Value.AskedSeconds)
                least = Math.Min(least, slot.Value.AskedSeconds / granted);
        }

        return least;
    }

    private void ForgetIdle(TimeSpan now)
    {
        _idle.Clear();
        foreach (KeyValuePair<ulong, Slot> slot in _slots)
        {
            if (!slot.Value.IsPending && now - slot.Value.LastPut > Forgotten)
                _idle.Add(slot.Key);
        }

        foreach (ulong key in _idle)
            _slots.Remove(key);
    }

    private static double Mean(double mean, TimeSpan interval)
        => mean == 0 ? interval.ExactSeconds : mean + (Weight * (interval.ExactSeconds - mean));

    private sealed class Slot
    {
        public FrameToSend Frame;
        public bool IsPending;
        public TimeSpan LastPut;
        public TimeSpan LastSent;
        public double AskedSeconds;
        public double GrantedSeconds;

        // When it may be sent, and when its piece may be sent again, in virtual time.
        public double Start;
        public double Finish;
    }
}
