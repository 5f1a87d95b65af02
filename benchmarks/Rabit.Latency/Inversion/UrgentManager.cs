using System;
using System.Threading;
using Rabit.Core;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;

namespace Rabit.Latency.Inversion;

/// <summary>
/// The manager of the highest priority: uses its endpoint some 3000 times a second, and measures that.
/// </summary>
internal sealed class UrgentManager : CallingManager, IDisposable
{
    private readonly AutoResetEvent _full = new(initialState: false);
    private readonly LatencyHistogram _durations = new();   // the manager's while _left is not 0, the measurer's else
    private int _left;

    public UrgentManager(int priority, int cpu, EndpointCall call, RabitWorkspace workspace)
        : base("highest", priority, cpu, call, workspace)
        // No multiple of the others' periods: it meets them at all their places.
        => Period = TimeSpan.FromTicks(3137);

    /// <summary>Measures so many calls; waits for the last.</summary>
    public LatencyHistogram Measure(int calls)
    {
        _durations.Clear();
        Volatile.Write(ref _left, calls);
        _full.WaitOne();
        return _durations;
    }

    public void Dispose() => _full.Dispose();

    protected override void ExecuteUnitOfWork()
    {
        long before = MonotonicClock.Now;
        Call();
        long duration = MonotonicClock.Now - before;
        if (Volatile.Read(ref _left) == 0)
            return;
        _durations.Record(duration);
        if (Interlocked.Decrement(ref _left) == 0)
            _full.Set();
    }
}
