using System;
using Rabit.Core;

namespace Rabit.Benchmarks.Core;

/// <summary>Sleeps, and takes no time from what is measured outside managers.</summary>
internal sealed class IdleManager : RabitManager
{
    public IdleManager()
        : base("idle") => WakeUpDelay = TimeSpan.FromDays(1);

    protected override void ExecuteUnitOfWork()
    {
    }
}
