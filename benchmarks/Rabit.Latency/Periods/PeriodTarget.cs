using System;

namespace Rabit.Latency.Periods;

/// <summary>Something that runs with a period.</summary>
internal abstract class PeriodTarget : IDisposable
{
    /// <summary>Runs until the record is full; the calling thread waits.</summary>
    public abstract void Run(TimeSpan period, DeadlineRecord record);

    public abstract void Dispose();

    public double[] Lateness(TimeSpan period, int samples) => Collect(period, samples).Lateness();

    public DeadlineRecord Collect(TimeSpan period, int samples)
    {
        var record = new DeadlineRecord(period.Ticks * 100, samples);
        Run(period, record);
        if (!record.IsFull)
            throw new InvalidOperationException("A periodic thread ended early.");
        return record;
    }
}
