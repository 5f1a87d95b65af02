using System;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Managers;

/// <summary>
/// Something that runs in steps and sleeps between them: a manager, a blocking reader or a blocking writer. It knows
/// neither threads nor schedulers; the engine of the reactor's time dispatches its steps, all on one thread at a time.
/// </summary>
internal abstract class Activity(string name, WakeUpEvent wakeUp)
{
    public string Name { get; } = name;

    public WakeUpEvent WakeUp { get; } = wakeUp;

    /// <summary>How long the next step takes in virtual time.</summary>
    public TimeSpan ModelledDuration { get; set; }

    /// <summary>What the activity is doing, for the report that it does not stop.</summary>
    public abstract string Doing { get; }

    /// <summary>
    /// Whether the end has work left that takes its time, so that <see cref="Unblock"/> comes only when the time is up.
    /// </summary>
    public virtual bool DrainsAtEnd => false;

    /// <summary>Before the first step, before the start-up barrier.</summary>
    public abstract void Begin();

    public abstract NextStep RunStep(ConsumedWakeUps wakes, TimeSpan? wokenAt);

    /// <summary>After the last step.</summary>
    public abstract void End();

    /// <summary>
    /// Instead of all further steps and <see cref="End"/>, on the thread of the steps: something left them that nothing
    /// expects. May be called again where it throws.
    /// </summary>
    /// <returns>Whether the fault is in the result; else the run itself fails with it.</returns>
    public virtual bool TryEndAfter(Exception unexpected) => false;

    /// <summary>From another thread: let a step that blocks return soon.</summary>
    public virtual void Unblock()
    {
    }
}
