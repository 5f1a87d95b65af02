using System;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// A manager is judged by its own status.
internal static partial class HealthRules
{
    public static readonly HealthRule<ManagerFacts>[] OfManagers =
    [
        new(HealthReasons.ManagerFaulted, HealthLevel.Critical, HealthAdvice.ReturnToLaunch)
        {
            When = static (in ManagerFacts m, HealthOptions _)
                => m.State is ManagerState.Faulted or ManagerState.Restarting || m.HasFaultedRecently,
            Figure = static (in ManagerFacts m) => m.Faults,
            Text = static f => $"manager {f.Subject} faulted ({f.Figure} faults so far)",
            Condition = static _ => "its state is Faulted or Restarting, or it threw",
            End = static o => $"it runs, and {Seconds(o.RecentWindow)} without another fault",
            Why = "one that threw once may throw again; home is the better place for it. "
                + "5 s is several times the longest delay of `FaultPolicy.CarryOn`",
        },
        new(HealthReasons.ManagerHangs, HealthLevel.Critical, HealthAdvice.ReturnToLaunch)
        {
            When = static (in ManagerFacts m, HealthOptions _) => m.State == ManagerState.Hanging,
            Figure = static (in ManagerFacts m) => m.HangingSince.Ticks,
            Text = static f => $"manager {f.Subject} hangs (since {Seconds(f.Figure)} s)",
            Condition = static _ => "the watchdog of Rabit.Core found that it hangs: 5 s in a unit of work, unless its "
                + "`HangPolicy` sets another time",
            End = static _ => "its unit of work ends",
            Why = "whatever it does in flight is not done",
        },
        new(HealthReasons.ManagerStuck, HealthLevel.Critical, HealthAdvice.None)
        {
            When = static (in ManagerFacts m, HealthOptions o) => IsQuietFor(m, o.StuckAfter),
            Figure = static (in ManagerFacts m) => m.WakeUpDelay.Ticks,
            Text = static f => $"manager {f.Subject} is stuck (it should run every {Seconds(f.Figure)} s)",
            Condition = static o => "no unit of work of it began for its wake-up delay and "
                + $"{Seconds(o.StuckAfter)} more (before its first: since ours)",
            End = static _ => "a unit of work begins",
            Why = "a small computer that is busy for a moment is no reason to abort a mission; our heartbeat stops",
        },
        new(HealthReasons.ManagerStuck, HealthLevel.Critical, HealthAdvice.ReturnToLaunch)
        {
            Supersedes = HealthReasons.ManagerStuck,
            When = static (in ManagerFacts m, HealthOptions o) => IsQuietFor(m, o.StuckReturnToLaunchAfter),
            Figure = static (in ManagerFacts m) => m.WakeUpDelay.Ticks,
            Condition = static o => $"the same, with {Seconds(o.StuckReturnToLaunchAfter)} more",
            End = static _ => "a unit of work begins",
            Why = "as for a manager that hangs",
        },
    ];

    private static bool IsQuietFor(in ManagerFacts manager, TimeSpan longer)
        => IsRunning(manager) && manager.QuietFor > manager.WakeUpDelay + longer;
}
