using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Core.Time;

/// <summary>
/// How long the units of work of one manager are modelled to take: the usual duration, drawn from a range, and single
/// longer ones. Used by the thread of the run only.
/// </summary>
internal sealed class UnitOfWorkDurations(long seed, string managerName)
{
    // By time; the next one last.
    private readonly List<(TimeSpan At, TimeSpan Duration)> _single = [];

    // A stream of its own: what one manager draws changes nothing for the others, nor for the order.
    private SplitMix64 _random = new(unchecked((ulong)seed ^ HashOf(managerName)));
    private TimeSpan _shortest;
    private TimeSpan _longest;

    public TimeSpan Longest => _single.Select(s => s.Duration).Append(_longest).Max();

    public void SetUsual(TimeSpan shortest, TimeSpan longest)
    {
        _shortest = shortest;
        _longest = longest;
    }

    public void Add(TimeSpan at, TimeSpan duration)
    {
        int index = _single.FindIndex(s => s.At <= at);
        _single.Insert(index < 0 ? _single.Count : index, (at, duration));
    }

    public TimeSpan TakeNext(TimeSpan now)
    {
        int last = _single.Count - 1;
        if (last < 0 || _single[last].At > now)
            return Draw();
        TimeSpan duration = _single[last].Duration;
        _single.RemoveAt(last);
        return duration;
    }

    private TimeSpan Draw()
    {
        ulong choices = (ulong)(_longest - _shortest).Ticks + 1;
        return choices == 1 ? _shortest : _shortest + new TimeSpan((long)(_random.Next() % choices));
    }

    /// <summary>FNV-1a, 64 bits (Fowler, Noll, Vo): the same on every runtime, as string.GetHashCode is not.</summary>
    private static ulong HashOf(string text)
    {
        ulong hash = 0xCBF29CE484222325;
        foreach (char c in text)
            hash = unchecked((hash ^ c) * 0x100000001B3);
        return hash;
    }
}
