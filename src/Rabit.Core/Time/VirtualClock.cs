using System;
using System.Threading;

namespace Rabit.Core.Time;

/// <summary>A clock that stands still until the virtual-time engine moves it. Read from any thread.</summary>
internal sealed class VirtualClock(DateTimeOffset startUtc) : TimeProvider
{
    private readonly DateTimeOffset _startUtc = startUtc.ToUniversalTime();   // a TimeProvider gives the offset zero

    private long _ticks;   // written by the engine's thread, read by all; 64 bits, so only through Interlocked

    private long _steppedTicks;   // written by any thread, read by all; the same

    public override long TimestampFrequency => TimeSpan.TicksPerSecond;

    public override TimeZoneInfo LocalTimeZone => TimeZoneInfo.Utc;

    public override long GetTimestamp() => Interlocked.Read(ref _ticks);

    public override DateTimeOffset GetUtcNow() => UtcAt(Interlocked.Read(ref _steppedTicks));

    public override ITimer CreateTimer(TimerCallback callback, object? state, TimeSpan dueTime, TimeSpan period)
        => throw new NotSupportedException(
            "Virtual time has no timers beside the wake-up delays of its managers: a timer's thread would run beside "
                + "the steps of the run.");

    /// <summary>Steps the wall clock; timestamps go on.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no such date.</exception>
    public void StepUtc(TimeSpan by)
    {
        _ = UtcAt(Interlocked.Read(ref _steppedTicks)) + by;
        Interlocked.Add(ref _steppedTicks, by.Ticks);
    }

    public void MoveTo(TimeSpan now) => Interlocked.Exchange(ref _ticks, now.Ticks);

    private DateTimeOffset UtcAt(long steppedTicks) => _startUtc.AddTicks(GetTimestamp()).AddTicks(steppedTicks);
}
