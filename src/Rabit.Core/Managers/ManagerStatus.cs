using System;

namespace Rabit.Core;

/// <summary>
/// What a manager reports of itself: a message of its own (<see cref="RabitManager.SubscribeToStatus"/>), posted when
/// its state changes and after every unit of work, and, when it hangs, by the watchdog in its place. A plain value.
/// </summary>
public struct ManagerStatus
{
    // Counted up in place with every run, instead of copied there and back.
    internal WakeUpStatistics _wakeUps;
    internal DurationStatistics _unitOfWorkTime;
    internal DurationStatistics _wakeLatency;
    internal DurationStatistics _periodError;

    /// <summary>Where the manager is in its life.</summary>
    public ManagerState State { get; internal set; }

    /// <summary>Units of work that were run.</summary>
    public long Runs { get; internal set; }

    /// <summary>Why they were run.</summary>
    public readonly WakeUpStatistics WakeUps => _wakeUps;

    /// <summary>
    /// How long they took, by the clock of the run: in virtual time their modelled duration; of one that hangs when it
    /// is back, or up to the end of the run.
    /// </summary>
    public readonly DurationStatistics UnitOfWorkTime => _unitOfWorkTime;

    /// <summary>
    /// From the wake-up (or the moment the timer was due) to the unit of work, where the manager slept.
    /// </summary>
    public readonly DurationStatistics WakeLatency => _wakeLatency;

    /// <summary>
    /// How late after its deadline each unit of work that <see cref="RabitManager.Period"/> caused began.
    /// </summary>
    public readonly DurationStatistics PeriodError => _periodError;

    /// <summary>Exceptions that left the manager's code.</summary>
    public long Faults { get; internal set; }

    /// <summary>The last one: stage, type and text. Null when there was none.</summary>
    public string? LastFault { get; internal set; }

    /// <summary>How often it was started up again after a fault.</summary>
    public long Restarts { get; internal set; }

    /// <summary>How often the watchdog found it hanging.</summary>
    public long Hangs { get; internal set; }

    /// <summary>The last time: stage, for how long, and what it was doing. Null when there was none.</summary>
    public string? LastHang { get; internal set; }

    /// <summary>
    /// When it entered the code that it does not return from, by <see cref="RabitManager.Now"/>; zero unless it is
    /// <see cref="ManagerState.Hanging"/>.
    /// </summary>
    public TimeSpan HangingSince { get; internal set; }

    /// <summary>
    /// Deadlines of <see cref="RabitManager.Period"/> that passed before their unit of work could begin.
    /// </summary>
    public long MissedDeadlines { get; internal set; }

    /// <summary>
    /// Units of work that ended later than <see cref="RabitManager.UnitOfWorkDeadline"/> allows.
    /// </summary>
    public long LateUnitsOfWork { get; internal set; }

    /// <summary>
    /// Processor time that went into <see cref="RabitManager.SpinBeforeSleep"/>: what it cost so far.
    /// </summary>
    public TimeSpan SpinTime { get; internal set; }

    /// <summary>The wake-up delay or the period that holds now.</summary>
    public TimeSpan WakeUpDelay { get; internal set; }

    /// <summary>When the last unit of work began, by <see cref="RabitManager.Now"/>.</summary>
    public TimeSpan LastRunAt { get; internal set; }
}
