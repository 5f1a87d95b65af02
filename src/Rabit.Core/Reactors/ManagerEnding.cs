using System;
using System.Collections.Generic;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;

namespace Rabit.Core.Reactors;

/// <summary>Stops a manager with its devices: readers first, so that nothing comes in any more, writers last, so that what is left goes out.</summary>
internal sealed class ManagerEnding(ReactorEngine engine, RabitLog log, TimeSpan stopTimeout)
{
    public ManagerResult End(ManagerActivity activity)
    {
        var notStopped = new List<string>();
        foreach (DeviceActivity reader in activity.Manager.Readers)
            End(reader, notStopped);

        // Whoever was given a thread, even if a stop came before it took its first step; the engine knows.
        End(activity, notStopped);
        foreach (DeviceActivity writer in activity.Manager.Writers)
        {
            End(writer, notStopped);
            if (!writer.HasBegun)
                writer.Abandon();
        }

        ManagerResult result = ResultOf(activity, notStopped);
        result.RealTime = activity.Manager.RealTimeReport;
        log.Write(RabitLogKind.Lifecycle, activity.Name, result.ToString());
        return result;
    }

    private static ManagerResult ResultOf(ManagerActivity activity, List<string> notStopped)
    {
        (IReadOnlyList<ManagerFault> faults, long count) = activity.Faults;
        ManagerOutcome outcome = !activity.HasBegun ? ManagerOutcome.NotStarted
            : notStopped.Count > 0 ? ManagerOutcome.DidNotStop
            : count > 0 ? ManagerOutcome.Faulted
            : ManagerOutcome.Ended;
        return new ManagerResult(activity.Name, outcome, activity.Runs, count, faults, notStopped);
    }

    private void End(Activity activity, List<string> notStopped)
    {
        if (!engine.TryEnd(activity, stopTimeout))
            notStopped.Add($"{activity.Name}: {activity.Doing}");
    }
}
