using System;
using System.Diagnostics;
using System.Reflection;

namespace Rabit.Mavlink.Speed;

/// <summary>
/// Measures one operation: the best time of several passes, and what they allocated together. The passes of all that is
/// compared are made in turn, so that a machine that is slow for a while, or runs at another clock rate, is so for all
/// of them.
/// </summary>
internal sealed class Measurement(string name, int frames, int bytesOnWire, Action work)
{
    // A pass is long enough for the stopwatch, and so short that the best one was not interrupted, even on a busy
    // machine.
    private const double SecondsPerPass = 0.002;

    private const double Gain = 0.98;

    // Not in the reference assemblies of net472.
    private static readonly Func<long>? AllocatedBytesSoFar = (Func<long>?)typeof(GC)
        .GetMethod("GetAllocatedBytesForCurrentThread", BindingFlags.Public | BindingFlags.Static)
            ?.CreateDelegate(typeof(Func<long>));

    private int _callsPerPass = 1;
    private double _bestSeconds = double.MaxValue;

    public string Name { get; } = name;

    /// <summary>What the C baseline calls the same.</summary>
    public string? CName { get; init; }

    /// <summary>
    /// By which factor it may be slower than copy and checksum before it counts as a regression, on .NET and on Mono.
    /// </summary>
    public (double Net, double Mono) MaxRatio { get; init; } = (double.PositiveInfinity, double.PositiveInfinity);

    public double SecondsPerFrame => _bestSeconds / _callsPerPass / frames;

    public double BytesPerSecond => bytesOnWire / (SecondsPerFrame * frames);

    /// <summary>Collections of the youngest generation in all passes.</summary>
    public int Collections { get; private set; }

    /// <summary>Allocated in all passes, where the runtime counts it.</summary>
    public long AllocatedBytes { get; private set; }

    /// <summary>
    /// Works until the runtime has made its best code of it, and measures how many calls fit into a pass.
    /// </summary>
    public void Warm(double secondsWithoutGain)
    {
        var watch = Stopwatch.StartNew();
        int done = 0;
        double best = double.MaxValue;
        double bestAtGain = double.MaxValue;
        double lastGain = 0;
        while (watch.Elapsed.TotalSeconds < lastGain + secondsWithoutGain || done < 200)
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

        _callsPerPass = (int)Math.Max(1, SecondsPerPass / best);
    }

    public void Pass()
    {
        int collections = GC.CollectionCount(0);
        long allocated = AllocatedBytesSoFar?.Invoke() ?? 0;
        long start = Stopwatch.GetTimestamp();
        for (int call = 0; call < _callsPerPass; call++)
            work();
        _bestSeconds = Math.Min(_bestSeconds, (Stopwatch.GetTimestamp() - start) / (double)Stopwatch.Frequency);
        AllocatedBytes += (AllocatedBytesSoFar?.Invoke() ?? 0) - allocated;
        Collections += GC.CollectionCount(0) - collections;
    }
}
