using System;

namespace Rabit.Core.WakeUp;

/// <summary>
/// The wakes that came before a restart or in a back-off, for the unit of work after it: none is lost, and the
/// timer that ended the wait is none of the manager's.
/// </summary>
/// <remarks>The tests explore it, with wakes at any time of a restart (docs/concepts/proof.md).</remarks>
internal struct KeptWakeUps
{
    private ConsumedWakeUps _kept;
    private bool _isFirstRun;   // after a restart

    /// <summary>Keeps wakes for the next unit of work.</summary>
    public void Keep(ConsumedWakeUps wakes) => _kept = _kept.With(wakes);

    /// <summary>Keeps wakes of a manager that is to be restarted.</summary>
    /// <returns>Whether it is too early: the next step waits for the time, and for no wake.</returns>
    public bool TryWait(ConsumedWakeUps wakes, TimeSpan now, TimeSpan resumeAt, out NextStep next)
    {
        Keep(wakes);
        next = NextStep.OnlyAt(resumeAt);
        return now < resumeAt;
    }

    /// <summary>
    /// After a start-up that threw nothing. The unit of work is a step of its own: a stop that came meanwhile causes
    /// no extra run, and a wake that came meanwhile is in it.
    /// </summary>
    public NextStep StartedAgain(TimeSpan end)
    {
        _isFirstRun = true;
        return NextStep.At(end);
    }

    /// <summary>What a unit of work begins with: the wakes that were kept, and the latest.</summary>
    public ConsumedWakeUps Take(ConsumedWakeUps latest)
    {
        ConsumedWakeUps wakes = _kept.With(latest);
        if (_isFirstRun)
            wakes = wakes.FirstAfterRestart();
        this = default;
        return wakes;
    }
}
