using System;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>One manager's status, and what of it was seen at the last look. One thread at a time.</summary>
internal sealed class ManagerStatusWatch(string name, RabitWorkspace workspace)
{
    private readonly MessageSubscriber<ManagerStatus> _status = workspace.SubscribeToStatus(name);
    private long _missedDeadlines;   // at the last look

    public void Look(ReactorLook look)
    {
        _status.Fetch();
        ManagerStatus status = _status.Value;
        look.Put(name, status);

        // From the start-up barrier to its first unit of work a manager is still Starting: nothing to report.
        switch (status.State)
        {
            case ManagerState.Hanging:
                look.Add(ReactorCondition.Hangs, $"{name} hangs: {status.LastHang}");
                break;
            case ManagerState.Faulted:
                look.Add(ReactorCondition.Faulted, $"{name} is faulted: {status.LastFault}");
                break;
            case ManagerState.Stopped:
                look.Add(ReactorCondition.Faulted, $"{name} has stopped: {status.LastFault ?? "the reactor stops"}");
                break;
            case ManagerState.Restarting:
                look.Add(ReactorCondition.Degraded, $"{name} is restarted: {status.LastFault}");
                break;
        }

        long missed = status.MissedDeadlines - _missedDeadlines;
        _missedDeadlines = status.MissedDeadlines;
        if (missed > 0)
            look.Add(
                ReactorCondition.Degraded,
                FormattableString.Invariant($"{name} missed {missed} deadlines since the last check"));
    }
}
