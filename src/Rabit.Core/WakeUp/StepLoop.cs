using System;
using Rabit.Core.Time;

namespace Rabit.Core.WakeUp;

/// <summary>Sleeps and runs steps until it is stopped: the event loop of every thread of the library.</summary>
/// <remarks>
/// Requirements: those of <see cref="WakeUpEvent{TSync}"/>. The loop keeps nothing from one step to the next but what
/// the step returned, so the explorer of the tests may begin it at any step.
/// </remarks>
internal sealed class StepLoop<TSync>(WakeUpEvent<TSync> wakeUp, IWaitSignal signal, RunClock clock)
    where TSync : struct, ISyncPoints
{
    // The kernel may let a thread whose time is just over sleep for the slack of its timers (50 µs): a sleep so short
    // looks at the clock first.
    private const long ShortSleepTicks = TimeSpan.TicksPerMillisecond;

    public void Run(NextStep next, Func<ConsumedWakeUps, TimeSpan?, NextStep> runStep)
    {
        while (true)
        {
            ConsumedWakeUps wakes = SleepUntil(next, out TimeSpan? wokenAt);
            if (wakes.Stop)
                return;
            next = runStep(wakes, wokenAt);
            if (next.IsNever)
                next = NextStep.OnlyAt(TimeSpan.MaxValue);
        }
    }

    private ConsumedWakeUps SleepUntil(NextStep next, out TimeSpan? wokenAt)
    {
        wokenAt = null;
        bool mayBeOver = (next.Due - next.NotBefore).Ticks < ShortSleepTicks;
        while (wakeUp.TryPrepareToWait(next.Wanted))
        {
            if (!mayBeOver || clock.Now < next.Due)
                signal.Wait(next.Due);
            if (wakeUp.Has(next.Wanted))
            {
                wokenAt = wakeUp.WokenAt;
                break;
            }

            if (clock.Now >= next.Due)
            {
                wokenAt = next.Due;
                return wakeUp.Consume().With(WakeUpCauses.Timer);
            }
        }

        return wakeUp.Consume();
    }
}
