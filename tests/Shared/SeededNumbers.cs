using System;

namespace Rabit.Tests.Shared;

/// <summary>Random numbers that are the same on every runtime (Steele, Lea, Flood, OOPSLA 2014, figure 17).</summary>
internal sealed class SeededNumbers(int seed)
{
    private ulong _state = (ulong)seed * 0x9E3779B97F4A7C15;

    public double Uniform()
    {
        _state += 0x9E3779B97F4A7C15;
        ulong mixed = (_state ^ (_state >> 30)) * 0xBF58476D1CE4E5B9;
        mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
        mixed ^= mixed >> 31;
        return (mixed >> 11) * (1.0 / (1UL << 53));
    }

    public double Uniform(double from, double to) => from + ((to - from) * Uniform());

    public int Below(int limit) => (int)(Uniform() * limit);

    public double Gauss() => Math.Sqrt(-2 * Math.Log(1 - Uniform())) * Math.Cos(2 * Math.PI * Uniform());
}
