using System;

namespace Rabit.Core.Tests.Exploration;

/// <summary>128 bits made of the numbers of a state.</summary>
internal struct StateKey : IEquatable<StateKey>
{
    private ulong _a;
    private ulong _b;

    // Two multiplicative hashes with unlike odd factors (from SplitMix64 and from the golden ratio); the shift carries
    // high bits back down.
    public void Add(int[] numbers, int from, int to)
    {
        for (int i = from; i < to; i += 2)
            Add(((ulong)(uint)numbers[i] << 32) | (i + 1 < to ? (uint)numbers[i + 1] : 0));
    }

    /// <summary>Whether it is the key of no state; that of one is so once in 10^38.</summary>
    public readonly bool IsNone => (_a | _b) == 0;

    private void Add(ulong numbers)
    {
        _a = (_a ^ numbers) * 0xBF58476D1CE4E5B9;
        _a ^= _a >> 32;
        _b = (_b + numbers + 1) * 0x9E3779B97F4A7C15;
        _b ^= _b >> 29;
    }

    public readonly bool Equals(StateKey other) => _a == other._a && _b == other._b;

    public override readonly bool Equals(object? obj) => obj is StateKey other && Equals(other);

    public override readonly int GetHashCode() => (int)_a;
}
