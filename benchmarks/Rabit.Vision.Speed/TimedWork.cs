using System;
using System.Diagnostics;

namespace Rabit.Vision.Speed;

/// <summary>A piece of work and its shortest time.</summary>
internal sealed class TimedWork(Action work)
{
    // Until the runtime has made its best code: at least so many calls, and so long.
    private const int WarmCalls = 200;
    private static readonly TimeSpan WarmTime = TimeSpan.FromSeconds(1.5);

    public double BestMilliseconds { get; private set; } = double.PositiveInfinity;

    /// <summary>Warms each, then does all in turn.</summary>
    public static void Measure(int passes, params TimedWork[] works)
    {
        foreach (TimedWork each in works)
            each.Warm();
        for (int pass = 0; pass < passes; pass++)
        {
            foreach (TimedWork each in works)
                each.Pass();
        }
    }

    private void Warm()
    {
        var watch = Stopwatch.StartNew();
        for (int call = 0; call < WarmCalls || watch.Elapsed < WarmTime; call++)
            work();
    }

    private void Pass()
    {
        long start = Stopwatch.GetTimestamp();
        work();
        double milliseconds = 1000.0 * (Stopwatch.GetTimestamp() - start) / Stopwatch.Frequency;
        BestMilliseconds = Math.Min(BestMilliseconds, milliseconds);
    }
}
