using System;
using Rabit.Core.Diagnostics;
using Rabit.Core.Locks;
using Rabit.Core.Managers;
using Rabit.Core.Supervision;
using Rabit.Core.Tests.RealTimeKit;
using Rabit.Core.Time;
using Xunit;

namespace Rabit.Core.Tests.Supervision;

/// <summary>The lock in which a manager that returns may wait for the watchdog.</summary>
public sealed class HangLockTests
{
    [Fact, Trait("Clause", "1.8")]
    public void Lock_OfAManagerWithAPriority_PassesItOn()
        => Assert.Equal(PriorityInheritanceMutex.IsThere, New(new RealTimeRequest { Priority = 1 }).InheritsPriority);

    [Fact, Trait("Clause", "1.8")]
    public void Lock_OfAManagerWithoutOne_IsAnOrdinaryOne()
        => Assert.False(New(new RealTimeRequest { WarmUpRuns = 1 }).InheritsPriority);

    private static HangWatch New(RealTimeRequest request)
    {
        var clock = new RunClock(TimeProvider.System);
        var run = new ManagerRun(
            clock, new RabitLog(_ => { }, logRuns: false, clock), HangPolicy.Off, keepsStatistics: true, _ => { });
        return new HangWatch(new RequestingManager("m", request), run);
    }
}
