using Rabit.Latency.Native;

namespace Rabit.Latency.Measuring;

/// <summary>What this process takes of a core.</summary>
internal static class CpuLoad
{
    /// <returns>
    /// Per cent of one core, all threads together, user and kernel; the calling thread sleeps meanwhile.
    /// </returns>
    public static double During(double seconds)
    {
        long cpu = MonotonicClock.CpuTime;
        long start = MonotonicClock.Now;
        MonotonicClock.SleepMilliseconds(seconds * 1e3);
        return 100.0 * (MonotonicClock.CpuTime - cpu) / (MonotonicClock.Now - start);
    }
}
