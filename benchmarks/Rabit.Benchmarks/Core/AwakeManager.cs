using System;
using System.Threading;
using Rabit.Core;

namespace Rabit.Benchmarks.Core;

/// <summary>Is in the middle of a unit of work, where a post finds it awake, until it is let go.</summary>
internal sealed class AwakeManager : RabitManager, IDisposable
{
    private readonly ManualResetEventSlim _end = new();

    public AwakeManager()
        : base("awake")
    {
        Subscribe<VehiclePose>("waking pose", wakeOnPost: true);
        WakeUpDelay = TimeSpan.FromDays(1);
    }

    public void LetGo() => _end.Set();

    public void Dispose() => _end.Dispose();

#pragma warning disable RABIT0002 // A benchmark's own affair: a manager of a real program does not wait for others.
    protected override void ExecuteUnitOfWork() => _end.Wait();
#pragma warning restore RABIT0002
}
