using System;
using System.Collections.Generic;
using Rabit.Core.Managers;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Queues;

/// <summary>
/// Ends the waits of async code that push into full queues. An activity like any other, so that it keeps the time of
/// the run, real or virtual; there is one only where the wiring needs it.
/// </summary>
internal sealed class QueueTimeKeeper(RunClock clock) : Activity("queue time limits", new WakeUpEvent())
{
    private readonly List<ITimeLimitedQueue> _queues = [];   // filled while wiring, then read only

    public override string Doing => "ending waits";

    public void Watch(ITimeLimitedQueue queue)
    {
        queue.TimeKeeper = WakeUp;
        _queues.Add(queue);
    }

    public override void Begin()
    {
    }

    public override NextStep RunStep(ConsumedWakeUps wakes, TimeSpan? wokenAt)
    {
        TimeSpan next = TimeSpan.MaxValue;
        foreach (ITimeLimitedQueue queue in _queues)
        {
            TimeSpan due = queue.ExpirePushes(clock.Now);
            next = due < next ? due : next;
        }

        return NextStep.At(next);
    }

    public override void End()
    {
    }
}
