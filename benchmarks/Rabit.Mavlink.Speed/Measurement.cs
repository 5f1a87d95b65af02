using System;
using System.Diagnostics;
using System.Reflection;

namespace Rabit.Mavlink.Speed;

/// <summary>The best time of several passes, and what they allocated together.</summary>
internal readonly struct Measurement
{
    public const int Passes = 300;

    // A pass is long enough for the stopwatch, and so short that the best one was not interrupted, even on a busy machine.
    private const double SecondsPerPass = 0.002;

    // The runtime makes its best code aside, for every kind of message by itself: for 300 kinds that has taken 15 s on a busy machine.
    // So nothing is measured before this long has passed without a gain worth the name.
    private const double SecondsWithoutGain = 3;
    private const double Gain = 0.98;

    // Not in the reference assemblies of net472.
    private static readonly Func<long>? AllocatedBytes = (Func<long>?)typeof(GC)
        .GetMethod("GetAllocatedBytesForCurrentThread", BindingFlags.Public | BindingFlags.Static)?.CreateDelegate(typeof(Func<long>));

    private Measurement(double seconds, long calls, int collections, long bytes)
    {
        Seconds = seconds;
        Calls = calls;
        Collections = collections;
        Bytes = bytes;
    }

    /// <summary>Of one call, in the best pass.</summary>
    public double Seconds { get; }

    /// <summary>How often the work was done in all passes.</summary>
    public long Calls { get; }

    /// <summary>Collections of the youngest generation in all passes.</summary>
    public int Collections { get; }

    /// <summary>Allocated in all passes, where the runtime tells.</summary>
    public long Bytes { get; }

    public static Measurement Of(Action work)
    {
        int calls = Warm(work);
        GC.Collect();
        int collections = GC.CollectionCount(0);
        long bytes = AllocatedBytes?.Invoke() ?? 0;
        double best = double.MaxValue;
        for (int pass = 0; pass < Passes; pass++)
        {
            long start = Stopwatch.GetTimestamp();
            for (int call = 0; call < calls; call++)
                work();
            best = Math.Min(best, (Stopwatch.GetTimestamp() - start) / (double)Stopwatch.Frequency);
        }

        bytes = (AllocatedBytes?.Invoke() ?? 0) - bytes;
        return new Measurement(best / calls, (long)calls * Passes, GC.CollectionCount(0) - collections, bytes);
    }

    // Until the runtime has made its best code of it; then as many calls as a pass has time for.
    private static int Warm(Action work)
    {
        var watch = Stopwatch.StartNew();
        int done = 0;
        double best = double.MaxValue;
        double lastGain = 0;
        double bestAtGain = double.MaxValue;
        while (watch.Elapsed.TotalSeconds < lastGain + SecondsWithoutGain || done < 200)
        {
            double before = watch.Elapsed.TotalSeconds;
            work();
            double now = watch.Elapsed.TotalSeconds;
            best = Math.Min(best, now - before);
            done++;
            if (best >= bestAtGain * Gain)
                continue;
            bestAtGain = best;
            lastGain = now;
        }

        return (int)Math.Max(1, SecondsPerPass / best);
    }
}
