using System;

namespace Rabit.Core;

/// <summary>How long the units of work of one manager take in virtual time. Used by the thread of the run only.</summary>
internal sealed class ModelledDuration(long seed, string managerName)
{
    // A stream of its own: what one manager draws changes nothing for the others, nor for the order.
    private SplitMix64 _random = new(unchecked((ulong)seed ^ HashOf(managerName)));
    private TimeSpan _shortest;
    private TimeSpan _longest;

    public void Set(TimeSpan shortest, TimeSpan longest)
    {
        _shortest = shortest;
        _longest = longest;
    }

    public TimeSpan Next()
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
