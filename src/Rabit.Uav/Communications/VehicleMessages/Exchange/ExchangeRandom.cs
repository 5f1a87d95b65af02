namespace Rabit.Uav.Communications;

/// <summary>Numbers by a seed: SplitMix64 (Steele, Lea, Flood 2014). One thread.</summary>
internal sealed class ExchangeRandom(long seed)
{
    private ulong _state = unchecked((ulong)seed);

    /// <summary>Makes the numbers to come others than those of another vehicle with the same seed.</summary>
    public void Stir(byte systemId) => _state = unchecked(_state ^ (systemId * 0xD1342543DE82EF95));

    /// <summary>A number from 0 to one less.</summary>
    public int Next(int below)
    {
        unchecked
        {
            _state += 0x9E3779B97F4A7C15;
            ulong mixed = (_state ^ (_state >> 30)) * 0xBF58476D1CE4E5B9;
            mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EB;
            mixed ^= mixed >> 31;
            return (int)(mixed % (ulong)below);
        }
    }
}
