using System;
using Rabit.Core.Diagnostics;
using Rabit.Core.Time;

namespace Rabit.Core;

/// <content>The deadline of each unit of work.</content>
public abstract partial class RabitManager
{
    private TimeSpan? _unitOfWorkDeadline;
    private bool _isLate;   // of the unit of work that has just ended; the manager's thread only

    /// <summary>
    /// How long after it became due a unit of work may end: its response time, from the wake-up that ended the sleep,
    /// or the moment of the timer or of <see cref="Period"/>. One that ends later is counted
    /// (<see cref="ManagerStatus.LateUnitsOfWork"/>) and <see cref="OnLateUnitOfWork"/> called, at its end; one that
    /// does not end is for the watchdog (<see cref="HangPolicy"/>). A wake-up during a unit of work counts from the end
    /// of that one. Null, the default, for none. Any code of the manager may change it.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Zero or negative.</exception>
    public TimeSpan? UnitOfWorkDeadline
    {
        get => _unitOfWorkDeadline;
        protected set
        {
            if (value is { } deadline && deadline <= TimeSpan.Zero)
                Require.Positive(deadline, nameof(value), $"The deadline of a unit of work of manager '{Name}'");
            _unitOfWorkDeadline = value;
        }
    }

    /// <summary>
    /// Called at the end of a unit of work that was late, as a part of it: an exception is a fault of the unit of work,
    /// and endpoints may be used, to post a degraded mode for example. Called too where the unit of work threw: that
    /// remains its fault, and what this throws then is logged.
    /// </summary>
    /// <param name="responseTime">From when it was due to its end, by the clock of the run.</param>
    protected virtual void OnLateUnitOfWork(TimeSpan responseTime)
    {
    }

    /// <summary>Whether the unit of work that has just ended was late; asked once.</summary>
    internal bool TakeLate()
    {
        bool isLate = _isLate;
        if (isLate)
            _isLate = false;
        return isLate;
    }

    // A unit of work that ends by an exception has ended, too.
    private void CheckDeadlineAfterFault(TimeSpan due, TimeSpan modelledDuration)
    {
        if (_unitOfWorkDeadline is not { } deadline)
            return;
        try
        {
            CheckDeadline(deadline, due, modelledDuration);
        }
        catch (Exception e)
        {
            // One unit of work has one fault: what its own code threw.
            Run.Log.Write(
                RabitLogKind.Fault, Name,
                $"{nameof(OnLateUnitOfWork)}, after a fault, threw {ExceptionText.Describe(e)}", e);
        }
    }

    private void CheckDeadline(TimeSpan deadline, TimeSpan due, TimeSpan modelledDuration)
    {
        TimeSpan responseTime = Times.Later(Run.Clock.Now, modelledDuration) - due;
        if (responseTime <= deadline)
            return;
        _isLate = true;
        OnLateUnitOfWork(responseTime);
    }
}
