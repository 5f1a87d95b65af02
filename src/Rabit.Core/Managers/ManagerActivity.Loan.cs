using System;
using System.Runtime.ExceptionServices;
using Rabit.Core.WakeUp;

namespace Rabit.Core.Managers;

/// <content>
/// Units of work on the thread of a reader (<see cref="RabitManager.RunsOnReaders"/>). The fields here, and all others
/// of the activity, belong to who is at work: the manager's thread, or the reader from a successful
/// <see cref="TryBorrow"/> to the end of <see cref="RunBorrowed"/>; the word of the wake-ups hands them over.
/// </content>
internal sealed partial class ManagerActivity
{
    private TimeSpan _ownDue;                    // until when the manager's thread sleeps
    private bool _wasLent;                       // since the manager's thread went to sleep
    private NextStep _afterLoan;                 // what the last step on a reader's thread returned
    private ExceptionDispatchInfo? _loanFault;   // what left it

    // One with a period has a grid of deadlines, which its own timer keeps; one that spins is to be woken by that.
    private bool LendsItself => lends && manager.Period is null && manager.SpinBeforeSleep == TimeSpan.Zero;

    /// <summary>Whether the calling thread, a reader's, is to run the next unit of work.</summary>
    public bool TryBorrow() => lends && WakeUp.TryBorrow();

    /// <summary>Runs a unit of work, for what has woken the manager since it was borrowed.</summary>
    public void RunBorrowed()
    {
        bool isToWake = true;
        try
        {
            ConsumedWakeUps wakes = WakeUp.ConsumeLent();
            if (!wakes.Stop)
            {
                _wasLent = true;
                _afterLoan = Step(wakes, run.Clock.Now);
            }

            isToWake = !wakes.Stop && (!_afterLoan.Lends || _afterLoan.Due < _ownDue);
        }
        catch (Exception e)
        {
            // Nothing expects it: the manager's thread ends by it.
            _wasLent = true;
            _loanFault = ExceptionDispatchInfo.Capture(e);
        }

        WakeUp.EndLoan(isToWake);
    }

    // On the manager's thread: whether it woke for nothing but a timer that units of work on readers have put off.
    private bool HasLoanLeft(ref ConsumedWakeUps wakes)
    {
        if (!_wasLent)
            return false;
        _wasLent = false;
        _loanFault?.Throw();
        bool isOver = _afterLoan.IsNever || run.Clock.Now >= _afterLoan.Due;
        if (!isOver && wakes.Causes == WakeUpCauses.Timer)
            return true;
        if (isOver || _afterLoan.Lends)
            return false;

        // It waits after a fault: wakes are kept until then.
        _kept.Keep(wakes);
        return true;
    }
}
