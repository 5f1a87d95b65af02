using System;
using System.Threading;

namespace Rabit.Core.Tests.Time;

/// <summary>A clock that stands where the test puts it, and lets the test step in whenever it is read.</summary>
internal sealed class ManualClock(long frequency = TimeSpan.TicksPerSecond) : TimeProvider
{
    private long _timestamp;
    private long _utcTicks = new DateTime(2020, 1, 1, 0, 0, 0, DateTimeKind.Utc).Ticks;

    public override long TimestampFrequency => frequency;

    public long Timestamp
    {
        get => Interlocked.Read(ref _timestamp);
        set => Interlocked.Exchange(ref _timestamp, value);
    }

    public DateTimeOffset Utc
    {
        set => Interlocked.Exchange(ref _utcTicks, value.UtcTicks);
    }

    /// <summary>Called when the timestamp is read, on that thread.</summary>
    public Action? OnRead { get; set; }

    public override long GetTimestamp()
    {
        OnRead?.Invoke();
        return Timestamp;
    }

    public override DateTimeOffset GetUtcNow() => new(Interlocked.Read(ref _utcTicks), TimeSpan.Zero);
}
