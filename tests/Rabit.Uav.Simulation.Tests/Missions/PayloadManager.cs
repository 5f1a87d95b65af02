using System;
using Rabit.Core;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>A manager of the user that flies along and can fail.</summary>
internal sealed class PayloadManager : RabitManager
{
    public const string ManagerName = "payload";

    private readonly TimeSpan _throwsAt;
    private bool _hasThrown;

    public PayloadManager(TimeSpan throwsAt, TimeSpan? sleepsFor = null)
        : base(ManagerName)
    {
        _throwsAt = throwsAt;
        WakeUpDelay = sleepsFor ?? TimeSpan.FromMilliseconds(500);
    }

    protected override void ExecuteUnitOfWork()
    {
        if (_hasThrown || Now < _throwsAt)
            return;
        _hasThrown = true;
        throw new InvalidOperationException("the payload has a bad moment");
    }
}
