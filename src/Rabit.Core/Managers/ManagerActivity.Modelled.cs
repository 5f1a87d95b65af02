using System;
using Rabit.Core.Time;
using Rabit.Core.Wiring;

namespace Rabit.Core.Managers;

/// <content>
/// Units of work with a modelled duration, in virtual time: the clock stands still while the code runs, and their end
/// lies ahead when it has returned.
/// </content>
internal sealed partial class ManagerActivity
{
    private ModelledRun _modelled;   // the last one

    /// <summary>
    /// Ends a unit of work whose modelled duration is over; in virtual time, where the watchdog calls it too.
    /// </summary>
    public void ComeBack()
    {
        if (!Hangs.IsInModelledWork)
            return;
        TimeSpan now = run.Clock.Now;
        if (!Hangs.TryEndModelled(now))
            return;
        SettleModelled(now);
        PostState(_state);
    }

    // The run ends, perhaps within a modelled duration: what lies beyond its end never happens.
    private void CutModelled()
    {
        if (_modelled.End == TimeSpan.Zero)
            return;
        TimeSpan now = run.Clock.Now;
        Hangs.CutModelled(now);
        SettleModelled(now);
    }

    // Its figures: those of a hang, which are counted when it is over; of others the deadlines that were counted ahead.
    private void SettleModelled(TimeSpan now)
    {
        TimeSpan end = Times.Earlier(now, _modelled.End);
        var scope = new RunningScope();
        scope.Enter(manager.Owner);
        ref ManagerStatus status = ref manager.StatusPublisher.Value;
        if (_modelled.IsToBeCounted)
            CountTimes(ref status, _modelled.Begin, end, _modelled.WokenAt, _modelled.Deadline);
        status.MissedDeadlines += _modelled.MissedUntil(end) - _modelled.MissedSoFar;
        scope.Leave();
        _modelled = default;
    }

    // In virtual time the clock stands still during a unit of work; its modelled duration is added.
    private void Leave(ManagerStage stage, TimeSpan begin)
    {
        if (stage == ManagerStage.UnitOfWork && ModelledDuration > TimeSpan.Zero)
        {
            _lastEnd = Times.Later(begin, ModelledDuration);
            Hangs.LeaveLater(begin, _lastEnd);
        }
        else
        {
            _lastEnd = run.Clock.Now;
            Hangs.Leave(_lastEnd);
        }
    }
}
