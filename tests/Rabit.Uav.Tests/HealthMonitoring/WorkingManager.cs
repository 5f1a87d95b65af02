using System;
using Rabit.Core;

namespace Rabit.Uav.Tests.HealthMonitoring;

/// <summary>A manager that works with its own period, and in the way that a test says.</summary>
internal sealed class WorkingManager : RabitManager
{
    private readonly Action<TimeSpan> _work;

    public WorkingManager(string name, double wakeUpSeconds = 0.1, Action<TimeSpan>? work = null)
        : base(name)
    {
        _work = work ?? (static _ => { });
        WakeUpDelay = TimeSpan.FromSeconds(wakeUpSeconds);
    }

    protected override void ExecuteUnitOfWork() => _work(Now);
}
