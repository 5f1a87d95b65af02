using System;
using System.Threading;
using Rabit.Core.RealTimeKit;
using Rabit.Core.Time;

namespace Rabit.Core.WakeUp;

/// <summary>Sleeps and runs steps until it is stopped: the event loop of every thread of the library.</summary>
/// <remarks>
/// Requirements: those of <see cref="WakeUpEvent{TSync}"/>. The loop keeps nothing from one step to the next but what
/// the step returned, so the explorer of the tests may begin it at any step. A spin before the sleep only reads: the
/// sleeper is awake, so a waker does not signal it, and what the spin finds the consume finds too.
/// </remarks>
/// <param name="wakeUp">What wakes it.</param>
/// <param name="signal">What ends its sleep.</param>
/// <param name="clock">Of the run.</param>
/// <param name="permit">Whether it may spin; null for yes.</param>
internal sealed class StepLoop<TSync>(
    WakeUpEvent<TSync> wakeUp, IWaitSignal signal, RunClock clock, SpinPermit? permit = null)
    where TSync : struct, ISyncPoints
{
    // The kernel may let a thread whose time is just over sleep for the slack of its timers (50 µs): a sleep so short
    // looks at the clock first.
    private const long ShortSleepTicks = TimeSpan.TicksPerMillisecond;

    // The clock costs as much as some looks.
    private const int LooksPerClock = 16;

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
        TimeSpan spun = next.Spin > TimeSpan.Zero && permit?.IsGiven != false ? Spin(next) : default;
        TimeSpan spunUntil = spun > TimeSpan.Zero ? next.NotBefore + spun : default;
        bool mayBeOver = (next.Due - next.NotBefore).Ticks < ShortSleepTicks || spun > TimeSpan.Zero;
        while (wakeUp.TryPrepareToWait(next.Wanted, next.Lends))
        {
            spunUntil = default;
            if (!mayBeOver || clock.Now < next.Due)
                signal.Wait(next.Due);
            while (next.Lends && !wakeUp.TakeBack())
                signal.Wait(TimeSpan.MaxValue);
            if (wakeUp.Has(next.Wanted))
            {
                wokenAt = wakeUp.WokenAt;
                break;
            }

            if (clock.Now >= next.Due)
            {
                wokenAt = next.Due;
                return wakeUp.Consume().With(WakeUpCauses.Timer).AfterSpin(spun);
            }
        }

        return wakeUp.Consume().AfterSpin(spun, spunUntil);
    }

    // From the end of the step, when the clock was read last, to now.
    private TimeSpan Spin(NextStep next)
    {
        TimeSpan end = Times.Earlier(Times.Later(next.NotBefore, next.Spin), next.Due);
        TimeSpan now = next.NotBefore;
        for (int looks = 1; now < end && !wakeUp.Has(next.Wanted); looks++)
        {
            Thread.SpinWait(1);
            if (looks % LooksPerClock == 0)
                now = clock.Now;
        }

        return clock.Now - next.NotBefore;
    }
}
