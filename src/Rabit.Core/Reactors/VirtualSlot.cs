using System;
using Rabit.Core.Managers;

namespace Rabit.Core.Reactors;

/// <summary>The place of one activity in virtual time.</summary>
internal sealed class VirtualSlot(Activity activity, VirtualEngine engine) : IWakeSignal
{
    public Activity Activity { get; } = activity;

    /// <summary>Set by a waker on any thread, under the engine's lock; cleared by the engine when the turn is given.</summary>
    public bool IsWoken { get; set; }

    /// <summary>When the waker came; null when the activity did not sleep then. Under the engine's lock.</summary>
    public TimeSpan? WokenAt { get; set; }

    /// <summary>The causes that end the sleep; see <see cref="NextTurn.Wanted"/>.</summary>
    public int Wanted { get; set; }

    public TimeSpan Due { get; set; } = TimeSpan.MaxValue;

    public TimeSpan NotBefore { get; set; }

    public bool HasEnded { get; set; }

    /// <summary>Turns taken at the present instant.</summary>
    public int RunsAtInstant { get; set; }

    /// <summary>How long its units of work are modelled to take; null for no time.</summary>
    public UnitOfWorkDurations? Durations { get; set; }

    /// <summary>When the next turn may be taken, as far as is known now. A stop waits for nothing.</summary>
    public TimeSpan NextTurnAt(TimeSpan now)
    {
        if (!IsWoken)
            return Max(NotBefore, Due);
        return Activity.WakeUp.StopRequested ? now : Max(NotBefore, now);
    }

    /// <summary>What the turns took in real time: written by the engine, read by any thread, under the engine's lock.</summary>
    public DurationStatistics RealTurnTime { get; set; }

    void IWakeSignal.Set() => engine.MarkWoken(this, Activity.WakeUp.WokenAt);

    private static TimeSpan Max(TimeSpan a, TimeSpan b) => a > b ? a : b;
}
