using System;
using System.Threading;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;

namespace Rabit.Latency.Wake;

/// <summary>A sleeper that reports how long after the post its first line ran.</summary>
internal abstract class WakeTarget : IDisposable
{
    // the sleeper's while it runs; read when all posts were received
    private readonly LatencyHistogram _histogram = new();
    private long _received;                                 // written by the sleeper, read by the poster

    public long Received => Interlocked.Read(ref _received);

    /// <summary>Hands the time over and wakes the sleeper; on the poster's thread.</summary>
    public abstract void Post(long now);

    public abstract void Dispose();

    /// <summary>Posts a number of times, 1 ms apart, from a thread on a CPU.</summary>
    /// <returns>p50, p99 and maximum in microseconds.</returns>
    public double[] Run(int cpu, int posts)
    {
        _histogram.Clear();
        Pinned.Run(cpu, () =>
        {
            for (int i = 0; i < posts; i++)
            {
                long due = Received + 1;
                MonotonicClock.SleepMilliseconds(1);
                Post(MonotonicClock.Now);
                WaitFor(due);
            }
        });
        return [_histogram.Percentile(0.5) / 1e3, _histogram.Percentile(0.99) / 1e3, _histogram.Max / 1e3];
    }

    /// <summary>Called by the sleeper, which read the clock first of all.</summary>
    protected void Record(long posted, long now)
    {
        _histogram.Record(now - posted);
        Interlocked.Increment(ref _received);
    }

    // The sleeper runs when the poster sleeps: they share a CPU. A wake that is lost shows here.
    private void WaitFor(long due)
    {
        long giveUp = MonotonicClock.Now + 2_000_000_000;
        while (Received < due)
        {
            if (MonotonicClock.Now > giveUp)
                throw new InvalidOperationException(
                    "A wake-up was lost: two seconds after the post the manager had not run.");
            MonotonicClock.SleepMilliseconds(0.1);
        }
    }
}
