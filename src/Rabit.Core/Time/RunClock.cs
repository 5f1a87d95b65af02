using System;

namespace Rabit.Core.Time;

/// <summary>
/// The clock of one reactor: time since the reactor was made, monotonic, in <see cref="TimeSpan"/> ticks of 100 ns.
/// </summary>
internal sealed class RunClock
{
    private const long NanosecondsPerSecond = 1_000_000_000;
    private const long NanosecondsPerTick = NanosecondsPerSecond / TimeSpan.TicksPerSecond;

    private readonly long _origin;

    // Every stamp of a post is taken here. Nanoseconds, what .NET on Linux counts, are divided by a constant, which
    // compilers turn into a multiplication; anything else is multiplied: exact to a tick up to 2^53 counts, monotonic
    // forever.
    private readonly bool _countsNanoseconds;
    private readonly double _ticksPerCount;

    public RunClock(TimeProvider provider)
    {
        Provider = provider;
        long frequency = provider.TimestampFrequency;
        _countsNanoseconds = frequency == NanosecondsPerSecond;
        _ticksPerCount = (double)TimeSpan.TicksPerSecond / frequency;
        _origin = provider.GetTimestamp();
        if (ReferenceEquals(provider, TimeProvider.System) && NanosecondsPerSecond % frequency == 0)
            SystemOriginNanoseconds = _origin * (NanosecondsPerSecond / frequency);
    }

    public TimeProvider Provider { get; }

    /// <summary>
    /// What <see cref="TimeProvider.System"/> showed at time zero of the run; null where the run has another clock.
    /// </summary>
    public long? SystemOriginNanoseconds { get; }

    public TimeSpan Now
    {
        get
        {
            long counts = Provider.GetTimestamp() - _origin;
            return new TimeSpan(_countsNanoseconds ? counts / NanosecondsPerTick : (long)(counts * _ticksPerCount));
        }
    }

    /// <summary>The time for a report that must get through although the user's clock may be what failed.</summary>
    public TimeSpan NowOr(TimeSpan otherwise)
    {
        try
        {
            return Now;
        }
        catch (Exception)
        {
            // The clock is the user's.
            return otherwise;
        }
    }
}
