using System;
using Rabit.Core.Managers;
using Rabit.Core.Synchronization;

namespace Rabit.Core.Reactors;

/// <summary>Sleeps and takes turns until it is stopped: the loop of every thread of ours.</summary>
/// <remarks>
/// Requirements: those of <see cref="WakeUpEvent{TSync}"/>. The loop keeps nothing from one turn to the next but what the turn returned, so
/// the explorer of the tests may begin it at any turn.
/// </remarks>
internal sealed class TurnLoop<TSync>(WakeUpEvent<TSync> wakeUp, IWaitSignal signal, RunClock clock)
    where TSync : struct, ISyncPoints
{
    // The kernel may let a thread whose time is just over sleep for the slack of its timers (50 µs): a sleep so short looks at the clock first.
    private const long ShortSleepTicks = TimeSpan.TicksPerMillisecond;

    public void Run(NextTurn next, Func<WakeUps, TimeSpan?, NextTurn> takeTurn)
    {
        while (true)
        {
            WakeUps wakes = SleepUntil(next, out TimeSpan? wokenAt);
            if (wakes.Stop)
                return;
            next = takeTurn(wakes, wokenAt);
            if (next.IsNever)
                next = NextTurn.OnlyAt(TimeSpan.MaxValue);
        }
    }

    private WakeUps SleepUntil(NextTurn next, out TimeSpan? wokenAt)
    {
        wokenAt = null;
        bool mayBeOver = (next.Due - next.NotBefore).Ticks < ShortSleepTicks;
        while (wakeUp.TryFallAsleep(next.Wanted))
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
                return wakeUp.Take().With(WakeUpCauses.Timer);
            }
        }

        return wakeUp.Take();
    }
}
