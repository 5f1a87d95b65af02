using System;
using System.Threading;
using Rabit.Core;
using Rabit.Latency.Native;

namespace Rabit.Latency.Measuring;

/// <summary>
/// A manager that works flat out within one unit of work, when it is given a job; in between it sleeps.
/// </summary>
internal abstract class FlatOutManager<TJob> : RabitManager, IDisposable
    where TJob : class
{
    private readonly AutoResetEvent _ended = new(initialState: false);
    private readonly int? _cpu;
    private TJob? _job;   // set from outside before the wake; taken by the manager

    protected FlatOutManager(string name, int? cpu)
        : base(name)
    {
        _cpu = cpu;
        WakeUpDelay = TimeSpan.FromHours(1);
    }

    public void Begin(TJob job)
    {
        Volatile.Write(ref _job, job);
        WakeUp();
    }

    public void WaitForEnd() => _ended.WaitOne();

    public void Dispose() => _ended.Dispose();

    protected override void Startup()
    {
        if (_cpu is { } cpu)
            Cpus.Pin(cpu);
    }

    protected override void ExecuteUnitOfWork()
    {
        if (Interlocked.Exchange(ref _job, null) is not { } job)
            return;
        Work(job);
        _ended.Set();
    }

    protected abstract void Work(TJob job);
}
