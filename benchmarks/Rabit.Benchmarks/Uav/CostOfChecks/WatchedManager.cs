using System;
using Rabit.Core;

namespace Rabit.Benchmarks.Uav.CostOfChecks;

/// <summary>Does nothing, so often that Health Monitoring finds that it works.</summary>
internal sealed class WatchedManager : RabitManager
{
    public WatchedManager(string name)
        : base(name)
        => Period = TimeSpan.FromMilliseconds(500);

    protected override void ExecuteUnitOfWork()
    {
    }
}
