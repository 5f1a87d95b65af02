using System;

namespace Rabit.Core;

/// <summary>The clock of one reactor: time since the reactor was made, monotonic, in <see cref="TimeSpan"/> ticks of 100 ns.</summary>
internal sealed class RunClock
{
    private readonly long _origin;

    // A multiplication instead of a division: exact to a tick for 104 days of nanosecond stamps (2^53 ns), monotonic for ever.
    private readonly double _ticksPerCount;

    public RunClock(TimeProvider provider)
    {
        Provider = provider;
        _ticksPerCount = (double)TimeSpan.TicksPerSecond / provider.TimestampFrequency;
        _origin = provider.GetTimestamp();
    }

    public TimeProvider Provider { get; }

    public TimeSpan Now => new((long)((Provider.GetTimestamp() - _origin) * _ticksPerCount));
}
