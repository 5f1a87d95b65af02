using System;
using Rabit.Core.Managers;
using Rabit.Core.Time;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Reactors;

/// <summary>The place of one activity in virtual time.</summary>
internal sealed class VirtualSlot(Activity activity, VirtualEngine engine) : IWakeSignal
{
    public Activity Activity { get; } = activity;

    /// <summary>
    /// Set by a waker on any thread, under the engine's lock; cleared by the engine when it dispatches the step.
    /// </summary>
    public bool IsWoken { get; set; }

    /// <summary>When the waker came; null when the activity did not sleep then. Under the engine's lock.</summary>
    public TimeSpan? WokenAt { get; set; }

    /// <summary>The causes that end the sleep; see <see cref="NextStep.Wanted"/>.</summary>
    public int Wanted { get; set; }

    public TimeSpan Due { get; set; } = TimeSpan.MaxValue;

    public TimeSpan NotBefore { get; set; }

    public bool HasEnded { get; set; }

    /// <summary>Steps run at the present instant.</summary>
    public int RunsAtInstant { get; set; }

    /// <summary>How long its units of work are modelled to take; null where it has none, being no manager.</summary>
    public UnitOfWorkDurations? Durations { get; init; }

    /// <summary>When the next step may run, as far as is known now. A stop waits for nothing.</summary>
    public TimeSpan NextStepAt(TimeSpan now)
    {
        if (!IsWoken)
            return Max(NotBefore, Due);
        return Activity.WakeUp.StopRequested ? now : Max(NotBefore, now);
    }

    /// <summary>
    /// What the steps took in real time: written by the engine, read by any thread, under the engine's lock.
    /// </summary>
    public DurationStatistics RealStepTime { get; set; }

    void IWakeSignal.Set() => engine.OnWake(this);

    private static TimeSpan Max(TimeSpan a, TimeSpan b) => a > b ? a : b;
}
