using System;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>
/// The newest samples in the order of their times, in fixed memory. A sample whose time is far from the newest one is
/// refused, be it before or after; when the next one agrees with it, a clock was set again, and both count. For one
/// thread.
/// </summary>
/// <param name="capacity">How many samples are kept.</param>
/// <param name="longestStep">
/// How far the time of a sample may be from the newest one, either way: further than samples come out of order.
/// </param>
internal sealed class TimedRing<T>(int capacity, TimeSpan longestStep)
{
    private readonly TimeSpan[] _times = new TimeSpan[capacity];
    private readonly T[] _values = new T[capacity];
    private int _first;
    private int _count;
    private bool _hasSuspect;
    private TimeSpan _suspectTime;
    private T _suspect = default!;

    public int Count => _count;

    /// <summary>
    /// Samples of a moment that is in it already, too old for the room there is, or far from all others in time.
    /// </summary>
    public long Refused { get; private set; }

    /// <summary>How often time jumped back, so that all before was forgotten.</summary>
    public long Restarts { get; private set; }

    /// <summary>Puts a sample where it belongs; late ones too.</summary>
    public void Add(TimeSpan time, in T value)
    {
        if (_count == 0 || (time - TimeAt(_count - 1)).Duration() <= longestStep)
        {
            _hasSuspect = false;
            Insert(time, value);
            return;
        }

        // One sample is not a clock: a datagram that the network repeated, or a wrong time. Nor is the same one twice.
        if (!_hasSuspect || time <= _suspectTime || time - _suspectTime > longestStep)
        {
            Refused++;
            (_hasSuspect, _suspectTime, _suspect) = (true, time, value);
            return;
        }

        // Ahead, nothing is wrong with what was before: there was a pause. Times before and after a clock was set back
        // cannot be compared.
        _hasSuspect = false;
        Refused--;
        if (time < TimeAt(_count - 1))
        {
            Restarts++;
            _count = 0;
        }

        Insert(_suspectTime, _suspect);
        Insert(time, value);
    }

    /// <summary>Finds the samples around a moment; both the same where one is of that very moment.</summary>
    public PoseLookup Find(TimeSpan time, TimeSpan longestGap, out TimedPair<T> pair)
    {
        pair = default;
        if (_count == 0 || time > TimeAt(_count - 1))
            return PoseLookup.NotYet;
        if (time < TimeAt(0))
            return PoseLookup.TooOld;
        int after = _count - 1;
        while (after > 0 && TimeAt(after - 1) >= time)
            after--;
        int before = TimeAt(after) == time ? after : after - 1;
        (TimeSpan beforeTime, TimeSpan afterTime) = (TimeAt(before), TimeAt(after));
        pair.Before = _values[Slot(before)];
        pair.After = _values[Slot(after)];
        pair.Seconds = (afterTime - beforeTime).ExactSeconds;
        pair.Part = before == after ? 0 : (time - beforeTime).Ticks / (double)(afterTime - beforeTime).Ticks;
        return afterTime - beforeTime > longestGap ? PoseLookup.Gap : PoseLookup.Known;
    }

    /// <summary>The newest sample; false if there is none.</summary>
    public bool TryNewest(out TimeSpan time, out T value)
    {
        (time, value) = _count > 0 ? (TimeAt(_count - 1), _values[Slot(_count - 1)]) : default;
        return _count > 0;
    }

    private void Insert(TimeSpan time, in T value)
    {
        int place = _count;
        while (place > 0 && TimeAt(place - 1) > time)
            place--;
        if ((place > 0 && TimeAt(place - 1) == time) || (place == 0 && _count == capacity))
        {
            Refused++;
            return;
        }

        if (_count == capacity)
        {
            _first = Slot(1);
            _count--;
            place--;
        }

        for (int i = _count; i > place; i--)
        {
            _times[Slot(i)] = _times[Slot(i - 1)];
            _values[Slot(i)] = _values[Slot(i - 1)];
        }

        _times[Slot(place)] = time;
        _values[Slot(place)] = value;
        _count++;
    }

    private TimeSpan TimeAt(int index) => _times[Slot(index)];

    private int Slot(int index)
    {
        int slot = _first + index;
        return slot < capacity ? slot : slot - capacity;
    }
}
