using System;
using Rabit.Core.Diagnostics;

namespace Rabit.Core.Managers;

/// <content>What remains to be done when something unexpected has left the activity's own code.</content>
internal sealed partial class ManagerActivity
{
    private bool _hasUnexpectedFault;   // the manager's thread only

    /// <summary>The system is stopped whatever the policy: what the manager could still do is not known.</summary>
    public override bool TryEndAfter(Exception unexpected)
    {
        RunningScope.Abandon(manager.Owner);
        if (!_hasUnexpectedFault)
            Faults.Add(new ManagerFault(Name, _stage, run.Clock.NowOr(_lastEnd), unexpected));
        _hasUnexpectedFault = true;

        manager.Halt();
        string text = $"{Name} ended unexpectedly in {_stage}: {ExceptionText.Describe(unexpected)}";
        run.RequestStop(text);
        run.Log.Write(RabitLogKind.Fault, Name, text, unexpected);
        if (_isUp)
            ShutDownUnexpectedly();
        TryPostUnexpected(text);
        return true;
    }

    // As ShutDown, with nothing in front of the manager's own code that could throw once more.
    private void ShutDownUnexpectedly()
    {
        _isUp = false;
        var scope = new RunningScope();
        scope.Enter(manager.Owner);
        Hangs.Enter(ManagerStage.Shutdown, run.Clock.NowOr(_lastEnd));
        try
        {
            manager.RunShutdown();
        }
        catch (Exception e)
        {
            // See Execute.
            Faults.Add(new ManagerFault(Name, ManagerStage.Shutdown, run.Clock.NowOr(_lastEnd), e));
        }

        scope.Leave();
        Hangs.Leave(run.Clock.NowOr(_lastEnd));
    }

    private void TryPostUnexpected(string text)
    {
        var scope = new RunningScope();
        scope.Enter(manager.Owner);
        try
        {
            ref ManagerStatus status = ref manager.StatusPublisher.Value;
            status.Faults++;
            status.LastFault = text;
            PostStatus(ref status, ManagerState.Faulted);
        }
        catch (Exception)
        {
            // The result has the fault; the status stays as it was posted last.
        }

        scope.Leave();
    }
}
