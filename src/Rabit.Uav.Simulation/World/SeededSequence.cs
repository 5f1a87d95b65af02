namespace Rabit.Uav.Simulation;

/// <summary>
/// A small seeded generator, the same on every runtime (Steele, Lea, Flood: "Fast splittable pseudorandom number
/// generators", OOPSLA 2014, figure 17). A changing value: keep it in a field or a local that is not copied.
/// </summary>
internal struct SeededSequence(ulong seed)
{
    private const ulong Golden = 0x9E3779B97F4A7C15;

    private ulong _state = seed;

    /// <summary>The next 64 bits.</summary>
    public ulong NextBits()
    {
        _state += Golden;
        return Mix(_state);
    }

    /// <summary>From 0 to below 1.</summary>
    public double NextUnit() => (NextBits() >> 11) * (1.0 / (1UL << 53));

    /// <summary>From -1 to below 1.</summary>
    public double NextSigned() => (2 * NextUnit()) - 1;

    /// <summary>From 0 to below the limit.</summary>
    public int Next(int limit) => (int)(((NextBits() >> 32) * (ulong)limit) >> 32);

    /// <summary>
    /// About normal with mean 0 and deviation 1: the sum of twelve uniform numbers, which needs no function that a
    /// runtime may compute in its own way. Never beyond 6.
    /// </summary>
    public double NextNormal()
    {
        double sum = -6;
        for (int i = 0; i < 12; i++)
            sum += NextUnit();
        return sum;
    }

    /// <summary>
    /// A seed for something else that hangs on this one: different purposes and numbers give unrelated sequences.
    /// </summary>
    public static ulong Derive(ulong seed, ulong purpose, ulong number = 0)
        => Mix(Mix(seed + (purpose * Golden)) + ((number + 1) * Golden));

    private static ulong Mix(ulong bits)
    {
        bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9;
        bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EB;
        return bits ^ (bits >> 31);
    }
}
