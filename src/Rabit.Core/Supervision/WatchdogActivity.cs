using System;
using System.Collections.Generic;
using Rabit.Core.Managers;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Supervision;

/// <summary>
/// Looks at all managers: in real time every now and then, on a thread of its own; in virtual time when a modelled
/// duration passes a limit or ends.
/// </summary>
internal sealed class WatchdogActivity(
    IReadOnlyList<ManagerActivity> managers, IReadOnlyList<StatusEndpoint> statuses, RunClock clock, TimeSpan interval,
    bool hasThreads)
    : Activity("watchdog", new WakeUpEvent())
{
    public override string Doing => "looking";

    public override void Begin()
    {
    }

    public override NextStep RunStep(ConsumedWakeUps wakes, TimeSpan? wokenAt)
    {
        TimeSpan now = clock.Now;
        TimeSpan next = Times.Later(now, interval);
        for (int i = 0; i < managers.Count; i++)
        {
            if (!hasThreads)
                managers[i].ComeBack();
            next = Times.Earlier(next, managers[i].Hangs.Check(now, statuses[i]));
        }

        return NextStep.At(next);
    }

    public override void End()
    {
    }
}
