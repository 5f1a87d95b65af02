using System;
using Rabit.Latency.Native;

namespace Rabit.Latency.Calls;

/// <summary>A number of calls in a row on one thread, and what they cost.</summary>
internal sealed class CallJob(int calls)
{
    public int Calls => calls;

    /// <summary>
    /// Processor time per call, and the collections of youngest objects meanwhile. Read when the job is done.
    /// </summary>
    public double[] Cost { get; private set; } = [];

    public void Measure(Action work)
    {
        int collections = GC.CollectionCount(0);
        long start = MonotonicClock.ThreadTime;
        work();
        long took = MonotonicClock.ThreadTime - start;
        Cost = [took / (double)calls, GC.CollectionCount(0) - collections];
    }
}
