using System;

namespace Rabit.Latency.Measuring;

/// <summary>
/// Counts of durations in fixed memory, in the manner of HDR histograms: buckets of equal width within each power of
/// two, so that every value is known to less than 1 %. Recording allocates nothing. For one thread at a time.
/// </summary>
internal sealed class LatencyHistogram
{
    private const int BitsPerOctave = 7;
    private const int Octaves = 40;      // up to 2^46 ns, 19 hours; what is longer counts as that
    private const int PerOctave = 1 << BitsPerOctave;

    private readonly long[] _counts = new long[(Octaves + 1) * PerOctave];

    public long Count { get; private set; }

    public long Max { get; private set; }

    /// <summary>Records a duration in nanoseconds; a negative one counts as zero.</summary>
    public void Record(long nanoseconds)
    {
        nanoseconds = Math.Max(0, nanoseconds);
        _counts[Math.Min(IndexOf(nanoseconds), _counts.Length - 1)]++;
        Count++;
        Max = Math.Max(Max, nanoseconds);
    }

    /// <summary>The duration in nanoseconds that a part of all does not exceed: the middle of its bucket.</summary>
    public double Percentile(double part)
    {
        long rank = (long)Math.Ceiling(part * Count);
        long seen = 0;
        for (int i = 0; i < _counts.Length; i++)
        {
            seen += _counts[i];
            if (seen >= rank && seen > 0)
                return Math.Min(MiddleOf(i), Max);
        }

        throw new InvalidOperationException("Nothing was recorded.");
    }

    public void Clear()
    {
        Array.Clear(_counts, 0, _counts.Length);
        Count = 0;
        Max = 0;
    }

    // Below 2^8 every value has a bucket of its own; each octave above has 2^7 of them.
    private static int IndexOf(long value)
    {
        int shift = 0;
        while (value >> shift >= 2 * PerOctave)
            shift++;
        return (shift * PerOctave) + (int)(value >> shift);
    }

    private static double MiddleOf(int index)
    {
        if (index < 2 * PerOctave)
            return index;
        int shift = (index / PerOctave) - 1;
        return ((double)(index - (shift * PerOctave)) + 0.5) * (1L << shift);
    }
}
