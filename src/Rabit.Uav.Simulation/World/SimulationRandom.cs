using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// A small seeded generator, the same on every runtime: SplitMix64 (Steele, Lea, Flood: "Fast splittable pseudorandom
/// number generators", OOPSLA 2014, figure 17), normal numbers by Box and Muller. Each purpose has a stream of its
/// own, so that one that draws more numbers than before changes nothing for the others.
/// </summary>
internal sealed class SimulationRandom
{
    private ulong _state;
    private double _spare;
    private bool _hasSpare;

    /// <summary>The stream of a purpose.</summary>
    public SimulationRandom(long seed, string purpose)
    {
        // FNV-1a of the name moves the seed; two rounds of the generator then part neighbouring seeds.
        ulong hash = 14_695_981_039_346_656_037;
        foreach (char character in purpose)
            hash = (hash ^ character) * 1_099_511_628_211;
        _state = hash ^ ((ulong)seed * 0x9E3779B97F4A7C15);
        _state = Next() ^ Next();
    }

    /// <summary>All 64 bits.</summary>
    public ulong Next()
    {
        _state += 0x9E3779B97F4A7C15;
        ulong mixed = _state;
        mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9;
        mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
        return mixed ^ (mixed >> 31);
    }

    /// <summary>From 0 to below 1.</summary>
    public double Uniform() => (Next() >> 11) * (1.0 / (1UL << 53));

    /// <summary>From a lower to below an upper limit.</summary>
    public double Uniform(double low, double high) => low + ((high - low) * Uniform());

    /// <summary>Normal, mean 0, standard deviation 1.</summary>
    public double Normal()
    {
        if (_hasSpare)
        {
            _hasSpare = false;
            return _spare;
        }

        double radius = Math.Sqrt(-2 * Math.Log(1 - Uniform()));
        double angle = 2 * Math.PI * Uniform();
        _spare = radius * Trig.Sin(angle);
        _hasSpare = true;
        return radius * Trig.Cos(angle);
    }

    /// <summary>
    /// Normal, mean 0, cut off at two standard deviations: for what is drawn once and must not spoil a whole run.
    /// </summary>
    public double ModestNormal(double sigma)
    {
        while (true)
        {
            double value = Normal();
            if (Math.Abs(value) <= 2)
                return sigma * value;
        }
    }
}
