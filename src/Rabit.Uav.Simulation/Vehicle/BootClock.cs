using System;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The autopilot's own clock: it was switched on before the run began, and it runs a little fast or slow.
/// </summary>
internal sealed class BootClock(TimeSpan bootedBefore, double driftPpm)
{
    private const double MicrosecondsPerTick = 0.1;

    /// <summary>One that was switched on at a time of the run.</summary>
    public static BootClock StartedAt(TimeSpan runTime, double driftPpm)
        => new(TimeSpan.FromTicks(-(long)(runTime.Ticks * (1 + (driftPpm * 1e-6)))), driftPpm);

    /// <summary>Microseconds since it was switched on, by its own count.</summary>
    public long Microseconds(TimeSpan runTime)
        => (long)((bootedBefore.Ticks + (runTime.Ticks * (1 + (driftPpm * 1e-6)))) * MicrosecondsPerTick);

    /// <summary>The <c>time_boot_ms</c> of its messages.</summary>
    public uint Milliseconds(TimeSpan runTime) => (uint)(Microseconds(runTime) / 1000);

    /// <summary>The nanoseconds of TIMESYNC.</summary>
    public long Nanoseconds(TimeSpan runTime) => Microseconds(runTime) * 1000;
}
