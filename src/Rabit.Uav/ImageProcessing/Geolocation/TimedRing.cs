using System;

namespace Rabit.Uav.ImageProcessing.Geolocation;

/// <summary>The newest samples in the order of their times, in fixed memory. For one thread.</summary>
internal sealed class TimedRing<T>(int capacity, TimeSpan longestStepBack)
{
    private readonly TimeSpan[] _times = new TimeSpan[capacity];
    private readonly T[] _values = new T[capacity];
    private int _first;
    private int _count;

    public int Count => _count;

    /// <summary>Samples of a moment that is in it already, or too old for the room there is.</summary>
    public long Refused { get; private set; }

    /// <summary>How often time jumped back, so that all before was forgotten.</summary>
    public long Restarts { get; private set; }

    /// <summary>Puts a sample where it belongs; late ones too.</summary>
    public void Add(TimeSpan time, in T value)
    {
        // A clock was set again: the times before and after cannot be compared.
        if (_count > 0 && time < TimeAt(_count - 1) - longestStepBack)
        {
            Restarts++;
            _count = 0;
        }

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
        pair.Seconds = (afterTime - beforeTime).TotalSeconds;
        pair.Part = before == after ? 0 : (time - beforeTime).Ticks / (double)(afterTime - beforeTime).Ticks;
        return afterTime - beforeTime > longestGap ? PoseLookup.Gap : PoseLookup.Known;
    }

    /// <summary>The newest sample; false if there is none.</summary>
    public bool TryNewest(out TimeSpan time, out T value)
    {
        (time, value) = _count > 0 ? (TimeAt(_count - 1), _values[Slot(_count - 1)]) : default;
        return _count > 0;
    }

    private TimeSpan TimeAt(int index) => _times[Slot(index)];

    private int Slot(int index)
    {
        int slot = _first + index;
        return slot < capacity ? slot : slot - capacity;
    }
}
