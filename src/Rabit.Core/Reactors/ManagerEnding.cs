using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Devices;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;
using Rabit.Core.Supervision;
using Rabit.Core.Time;

namespace Rabit.Core.Reactors;

/// <summary>
/// Stops managers in reverse order, each with its devices: readers first, so that nothing comes in any more, writers
/// last, so that what is left goes out.
/// </summary>
internal sealed class ManagerEnding(ReactorEngine engine, RunClock clock, RabitLog log, ReactorOptions options)
{
    private TimeSpan _deadline;
    private bool _isLate;

    /// <returns>In the order of the start.</returns>
    public List<ManagerResult> EndAll(IReadOnlyList<ManagerActivity> managers, ReactorSupervision supervision)
    {
        _deadline = Times.Later(clock.Now, options.TotalStopTimeout);
        var notStopped = new List<string>[managers.Count];
        for (int i = managers.Count - 1; i >= 0; i--)
            notStopped[i] = End(managers[i], managers.Take(i));

        var results = new List<ManagerResult>();
        for (int i = 0; i < managers.Count; i++)
            results.Add(ResultOf(managers[i], notStopped[i], supervision.StatusOf(i)));
        foreach (ManagerResult result in Enumerable.Reverse(results))
            log.Write(RabitLogKind.Lifecycle, result.Name, result.ToString());
        return results;
    }

    private List<string> End(ManagerActivity activity, IEnumerable<ManagerActivity> left)
    {
        if (!_isLate && clock.Now >= _deadline)
            AskAllToEnd(left);
        TimeSpan timeout = activity.Manager.StopTimeout ?? options.StopTimeout;
        var notStopped = new List<string>();
        foreach (DeviceActivity reader in activity.Manager.Readers)
            End(reader, timeout, notStopped);

        // Every activity that was given a thread, even if a stop came before its first step; the engine knows.
        End(activity, timeout, notStopped);
        foreach (DeviceActivity writer in activity.Manager.Writers)
        {
            End(writer, timeout, notStopped);
            if (!writer.HasBegun)
                writer.Abandon();
        }

        return notStopped;
    }

    private void AskAllToEnd(IEnumerable<ManagerActivity> left)
    {
        _isLate = true;
        log.Write(
            RabitLogKind.Note, "reactor",
            "the time to stop in order is over: all that are left are asked to stop at once");
        foreach (ManagerActivity activity in left)
        {
            foreach (Activity each
                in activity.Manager.Readers.Concat<Activity>([activity]).Concat(activity.Manager.Writers))
                engine.AskToEnd(each);
        }
    }

    private static ManagerResult ResultOf(ManagerActivity activity, List<string> notStopped, ManagerStatus status)
    {
        IReadOnlyList<ManagerFault> faults = activity.Faults.Read(out long faultCount);
        IReadOnlyList<ManagerHang> hangs = activity.Hangs.Found.Read(out long hangCount);
        ManagerOutcome outcome = !activity.HasBegun ? ManagerOutcome.NotStarted
            : notStopped.Count > 0 ? ManagerOutcome.DidNotStop
            : activity.HasStoppedAlone ? ManagerOutcome.StoppedAlone
            : faultCount > 0 ? ManagerOutcome.Faulted
            : ManagerOutcome.Ended;
        return new ManagerResult(activity.Name, outcome)
        {
            Runs = activity.Runs,
            Restarts = activity.Restarts,
            FaultCount = faultCount,
            Faults = faults,
            HangCount = hangCount,
            Hangs = hangs,
            NotStopped = notStopped,
            Status = status,
            RealTime = activity.Manager.RealTimeReport,
        };
    }

    private void End(Activity activity, TimeSpan timeout, List<string> notStopped)
    {
        if (!engine.TryEnd(activity, timeout, _deadline))
            notStopped.Add($"{activity.Name}: {activity.Doing}");
    }
}
