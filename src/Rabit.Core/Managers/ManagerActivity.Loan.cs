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
    private bool _hasFaultLeft;                  // its unit of work threw: what follows is for the manager's thread

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
                _afterLoan = Step(wakes, run.Clock.Now, isLent: true);
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

    // The loan ends with a wake of the manager's thread, and none can begin until that has slept again.
    private NextStep LeaveFault()
    {
        _hasFaultLeft = true;
        return NextStep.Never;
    }

    // On the manager's thread: whether what it woke for is over, or done here: a timer that units of work on readers
    // have put off, or a fault of theirs.
    private bool HasLoanLeft(ref ConsumedWakeUps wakes)
    {
        if (!_wasLent)
            return false;
        _wasLent = false;
        _loanFault?.Throw();
        if (_hasFaultLeft)
        {
            // Wakes are kept for the unit of work that may follow.
            _hasFaultLeft = false;
            _kept.Keep(wakes);
            _afterLoan = AfterFault();
            return true;
        }

        if (_afterLoan.IsNever || run.Clock.Now >= _afterLoan.Due)
            return false;
        if (wakes.Causes == WakeUpCauses.Timer)
            return true;
        wakes = wakes.Without(WakeUpCauses.Timer);
        return false;
    }
}
