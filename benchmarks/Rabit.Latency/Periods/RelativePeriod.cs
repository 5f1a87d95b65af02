using System;
using System.Threading;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;

namespace Rabit.Latency.Periods;

/// <summary>
/// A thread without Rabit that waits for the same time again and again: what the work and the wake-up take adds up.
/// </summary>
internal sealed class RelativePeriod(int cpu) : PeriodTarget
{
    private readonly AutoResetEvent _event = new(initialState: false);

    public override void Run(TimeSpan period, DeadlineRecord record) => Pinned.Run(cpu, () =>
    {
        record.Add(MonotonicClock.Now);
        while (!record.IsFull)
        {
            _event.WaitOne(period);
            record.Add(MonotonicClock.Now);
        }
    });

    public override void Dispose() => _event.Dispose();
}
