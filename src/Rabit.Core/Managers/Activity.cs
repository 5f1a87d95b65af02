using System;

namespace Rabit.Core.Managers;

/// <summary>
/// Something that takes turns and sleeps between them: a manager, a blocking reader or a blocking writer. It knows
/// neither threads nor schedulers; the engine of the reactor's time gives it its turns, all on one thread at a time.
/// </summary>
internal abstract class Activity(string name, WakeUpEvent wakeUp)
{
    public string Name { get; } = name;

    public WakeUpEvent WakeUp { get; } = wakeUp;

    /// <summary>How long the next turn will have taken in virtual time.</summary>
    public TimeSpan ModelledDuration { get; set; }

    /// <summary>What the activity is doing, for whoever finds that it does not end.</summary>
    public abstract string Doing { get; }

    /// <summary>Whether the end has work left that takes its time, so that <see cref="Unblock"/> comes only when the time is up.</summary>
    public virtual bool DrainsAtEnd => false;

    /// <summary>Before the first turn, before the start-up barrier.</summary>
    public abstract void Begin();

    public abstract NextTurn TakeTurn(WakeUps wakes, TimeSpan? wokenAt);

    /// <summary>After the last turn.</summary>
    public abstract void End();

    /// <summary>From another thread: let a turn that blocks come back soon.</summary>
    public virtual void Unblock()
    {
    }
}
