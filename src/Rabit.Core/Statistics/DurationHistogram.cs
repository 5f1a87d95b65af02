using System;

namespace Rabit.Core.Statistics;

/// <summary>
/// How often each length of a duration came: a log-linear histogram of fixed memory (2.8 KB), each octave in 16 equal
/// steps, so that a percentile is right to 6.25 %. One thread only.
/// </summary>
internal sealed class DurationHistogram
{
    // The bits of a double are its exponent and then its fraction, so the exponent with the first four bits of the
    // fraction is the bucket: no logarithm, no loop, the same on every runtime. Exact, since the ticks of 2^43 (ten
    // days) fit in the fraction; longer ones count as that.
    private const int StepBits = 4;
    private const int Shift = 52 - StepBits;
    private const int FirstBucket = (1023 << StepBits) - 1;   // that of one tick is 1; 0 is for no time at all
    private const long MaxTicks = (1L << 43) - 1;

    private readonly int[] _counts = new int[BucketOf(MaxTicks) + 1];
    private long _total;
    private int _highest;

    public void Add(TimeSpan duration)
    {
        int bucket = BucketOf(duration.Ticks);
        if (_counts[bucket] == int.MaxValue)
            return;
        _counts[bucket]++;
        _total++;
        if (bucket > _highest)
            _highest = bucket;
    }

    public void Clear()
    {
        Array.Clear(_counts, 0, _counts.Length);
        _total = 0;
        _highest = 0;
    }

    /// <summary>
    /// The durations that half, 99 % and 99.9 % of all do not exceed: the upper ends of their buckets.
    /// </summary>
    public void Percentiles(out TimeSpan half, out TimeSpan p99, out TimeSpan p999)
    {
        half = p99 = p999 = TimeSpan.Zero;
        if (_total == 0)
            return;
        long atHalf = _total - (_total / 2);
        long at99 = _total - (_total / 100);
        long at999 = _total - (_total / 1000);
        long passed = 0;
        for (int bucket = 0; bucket <= _highest; bucket++)
        {
            long before = passed;
            passed += _counts[bucket];
            if (before < atHalf && passed >= atHalf)
                half = UpperEnd(bucket);
            if (before < at99 && passed >= at99)
                p99 = UpperEnd(bucket);
            if (before < at999 && passed >= at999)
                p999 = UpperEnd(bucket);
        }
    }

    private static int BucketOf(long ticks)
        => ticks <= 0 ? 0 : (int)(BitConverter.DoubleToInt64Bits(Math.Min(ticks, MaxTicks)) >> Shift) - FirstBucket;

    // The largest whole number of ticks in the bucket.
    private static TimeSpan UpperEnd(int bucket)
    {
        if (bucket == 0)
            return TimeSpan.Zero;
        double next = BitConverter.Int64BitsToDouble((long)(bucket + FirstBucket + 1) << Shift);
        return new TimeSpan((long)Math.Ceiling(next) - 1);
    }
}
