using System;

namespace Rabit.Core.WakeUp;

/// <summary>
/// What a sleeper consumes when it wakes: the causes, how many wakes they came from, and whether to stop instead.
/// </summary>
internal readonly struct ConsumedWakeUps(
    WakeUpCauses causes, int count, bool stop, TimeSpan spun = default, TimeSpan spunUntil = default)
{
    public WakeUpCauses Causes { get; } = causes;

    public int Count { get; } = count;

    public bool Stop { get; } = stop;

    /// <summary>How long the sleeper looked for them before it slept, or instead.</summary>
    public TimeSpan Spun { get; } = spun;

    /// <summary>
    /// When that look ended, where no sleep followed: what the clock has just shown. Zero elsewhere.
    /// </summary>
    public TimeSpan SpunUntil { get; } = spunUntil;

    public ConsumedWakeUps With(ConsumedWakeUps later)
        => new(Causes | later.Causes, Count + later.Count, Stop || later.Stop, Spun + later.Spun);

    /// <summary>The timer that ended the wait for the restart was none of the manager's.</summary>
    public ConsumedWakeUps FirstAfterRestart()
        => new((Causes & ~WakeUpCauses.Timer) | WakeUpCauses.Start, Count, Stop, Spun);

    public ConsumedWakeUps With(WakeUpCauses more) => new(Causes | more, Count, Stop, Spun);

    public ConsumedWakeUps Without(WakeUpCauses some) => new(Causes & ~some, Count, Stop, Spun, SpunUntil);

    public ConsumedWakeUps AfterSpin(TimeSpan spun, TimeSpan until = default)
        => new(Causes, Count, Stop, spun, until);
}
