
namespace Rabit.Latency.Native;

/// <summary>CLOCK_MONOTONIC in nanoseconds: what all measured threads read, whatever they are measured for.</summary>
internal static unsafe class MonotonicClock
{
    public static long Now => Read(LinuxCalls.ClockMonotonic);

    /// <summary>CPU time of this process so far, all threads, in nanoseconds.</summary>
    public static long CpuTime => Read(LinuxCalls.ClockOfProcess);

    /// <summary>CPU time of the calling thread so far: what others do on the machine is not in it.</summary>
    public static long ThreadTime => Read(LinuxCalls.ClockOfThread);

    public static void SleepUntil(long nanoseconds)
    {
        TimeSpec until = TimeSpec.FromNanoseconds(nanoseconds);
        while (LinuxCalls.clock_nanosleep(LinuxCalls.ClockMonotonic, LinuxCalls.AbsoluteTime, &until, null) != 0)
        {
            // A Unix signal, as Mono's collector sends: the time is absolute, so it just goes on.
        }
    }

    public static void SleepMilliseconds(double milliseconds) => SleepUntil(Now + (long)(milliseconds * 1e6));

    private static long Read(int clock)
    {
        TimeSpec time;
        _ = LinuxCalls.clock_gettime(clock, &time);
        return time.TotalNanoseconds;
    }
}
