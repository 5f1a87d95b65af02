using System;
using System.Globalization;
using Rabit.Core.Managers;
using Rabit.Core.Time;

namespace Rabit.Core.Supervision;

/// <summary>
/// Reports the faults of one manager and decides, by its policy, what follows. The manager's thread only, but for the
/// list.
/// </summary>
internal sealed class FaultFollowUp(RabitManager manager, ManagerRun run)
{
    private readonly RestartWindow _restarts = new();
    private long _inARow;

    public BoundedList<ManagerFault> Faults { get; } = new();

    /// <summary>What follows the last fault.</summary>
    public FaultAction Action { get; private set; }

    /// <summary>No unit of work will follow.</summary>
    public bool IsHalted { get; private set; }

    /// <summary>Whether the next thing is a start-up.</summary>
    public bool IsRestarting { get; private set; }

    /// <summary>
    /// When it continues; what was carried on or restarted at a time that has passed continues at once.
    /// </summary>
    public TimeSpan ResumeAt { get; private set; }

    public void OnSuccessfulRun() => _inARow = 0;

    public void Resume() => IsRestarting = false;

    public void OnFault(ManagerFault fault, TimeSpan end, ref ManagerStatus status)
    {
        Faults.Add(fault);
        status.Faults++;
        status.LastFault = fault.ToString();
        run.Log.Write(RabitLogKind.Fault, manager.Name, status.LastFault, fault.Exception);

        FaultPolicy policy = manager.FaultPolicy;
        if (fault.Stage == ManagerStage.Shutdown)
        {
            // It is ending or restarting already, and continues with that.
            if (policy.Action == FaultAction.StopSystem)
                run.RequestStop(status.LastFault);
            return;
        }

        Action = policy.Action;
        string why = status.LastFault;
        if (Action == FaultAction.CarryOn)
        {
            ResumeAt = Times.Later(end, BackOff.Delay(policy.FirstDelay, policy.MaxDelay, _inARow++));
        }
        else if (Action == FaultAction.Restart)
        {
            IsRestarting = _restarts.TryTake(policy, end, out TimeSpan delay);
            ResumeAt = Times.Later(end, delay);
            if (!IsRestarting)
            {
                Action = policy.Finally;
                why = string.Format(
                    CultureInfo.InvariantCulture, "{0}, after {1} restarts within {2}", why, policy.MaxRestarts,
                    policy.Window);
                run.Log.Write(RabitLogKind.Note, manager.Name, $"is not restarted any more: {why}");
            }
        }

        IsHalted = Action is FaultAction.StopSystem or FaultAction.StopManager;
        if (IsHalted)
            manager.Halt();   // before the request: it delays none
        if (Action == FaultAction.StopSystem)
            run.RequestStop(why);
    }
}
