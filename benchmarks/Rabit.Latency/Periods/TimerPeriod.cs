using System;
using System.Threading;
using Rabit.Latency.Native;

namespace Rabit.Latency.Periods;

/// <summary>A <see cref="Timer"/>, which runs on the thread pool.</summary>
internal sealed class TimerPeriod : PeriodTarget
{
    public override void Run(TimeSpan period, DeadlineRecord record)
    {
        using var full = new ManualResetEvent(initialState: false);
        using (new Timer(_ => Tick(record, full), state: null, TimeSpan.Zero, period))
            full.WaitOne();
    }

    public override void Dispose()
    {
    }

    // Two callbacks may overlap.
    private static void Tick(DeadlineRecord record, ManualResetEvent full)
    {
        lock (record)
        {
            if (record.IsFull)
                return;
            record.Add(MonotonicClock.Now);
            if (record.IsFull)
                full.Set();
        }
    }
}
