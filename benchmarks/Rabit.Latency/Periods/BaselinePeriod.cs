using System;
using System.Threading;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;

namespace Rabit.Latency.Periods;

/// <summary>A thread without Rabit that sleeps until absolute deadlines.</summary>
internal sealed class BaselinePeriod(Action<long> sleepUntil, int cpu) : PeriodTarget
{
    public override void Run(TimeSpan period, DeadlineRecord record) => Pinned.Run(cpu, () =>
    {
        record.Add(MonotonicClock.Now);
        while (!record.IsFull)
        {
            sleepUntil(record.NextDeadline(MonotonicClock.Now));
            record.Add(MonotonicClock.Now);
        }
    });

    public override void Dispose()
    {
    }

    public static BaselinePeriod ByFutex(int cpu)
    {
        var word = new FutexWord();
        return new BaselinePeriod(until => word.WaitUntil(until), cpu);
    }
}
