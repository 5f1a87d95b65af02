using System;
using Rabit.Core.Managers;

namespace Rabit.Core.Reactors;

/// <summary>
/// Dispatches the steps of activities. The reactor decides what begins and ends when; the engine knows how, in its kind
/// of time.
/// </summary>
internal abstract class ReactorEngine : IDisposable
{
    /// <summary>Whether each activity has a thread.</summary>
    public virtual bool HasThreads => false;

    /// <summary>Lets an activity begin and returns when it has, or when a stop was requested.</summary>
    public abstract void Begin(Activity activity);

    /// <summary>Comes back when a stop was requested, or at the given time.</summary>
    public abstract void RunUntil(TimeSpan end);

    /// <summary>Asks an activity to stop and does not wait.</summary>
    public abstract void AskToEnd(Activity activity);

    /// <summary>Asks an activity to stop and lets it end.</summary>
    /// <param name="activity">Perhaps one that never began.</param>
    /// <param name="timeout">How long to wait; twice as long for one that has work left at its end.</param>
    /// <param name="deadline">When to stop waiting, by the clock of the run.</param>
    /// <returns>
    /// False when it did not within the time limit; it then keeps its thread, which does not keep the process.
    /// </returns>
    public abstract bool TryEnd(Activity activity, TimeSpan timeout, TimeSpan deadline);

    /// <summary>From any thread: <see cref="Begin"/> and <see cref="RunUntil"/> return soon.</summary>
    public abstract void RequestStop();

    /// <summary>From any thread: <see cref="RunUntil"/> returns at this time at the latest.</summary>
    public abstract void LimitRun(TimeSpan until);

    /// <summary>How long the steps of an activity took in real time, whatever the clock of the run says.</summary>
    public abstract DurationStatistics RealStepTime(Activity activity);

    public abstract void Dispose();
}
