using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>
/// The rules of Health Monitoring in one place: a table for managers, one for the vehicle, one for the camera, one for
/// links. Each row has its failsafe action, the advice in flight: return to launch on a low battery, say. Thresholds
/// are in <see cref="HealthOptions"/>.
/// </summary>
internal static class HealthRules
{
    private static readonly HealthRule<ManagerFacts>[] OfManagers =
    [
        new(HealthReasons.ManagerFaulted, HealthLevel.Critical, HealthAdvice.ReturnToLaunch,
            static (in ManagerFacts m, HealthOptions _) => m.State is ManagerState.Faulted or ManagerState.Restarting
                || m.HasFaultedRecently,
            static (in ManagerFacts m) => m.Faults),
        new(HealthReasons.ManagerHangs, HealthLevel.Critical, HealthAdvice.ReturnToLaunch,
            static (in ManagerFacts m, HealthOptions _) => m.State == ManagerState.Hanging,
            static (in ManagerFacts m) => m.HangingSince.Ticks),
        new(HealthReasons.ManagerStuck, HealthLevel.Critical, HealthAdvice.None,
            static (in ManagerFacts m, HealthOptions o) => IsQuietFor(m, o.StuckAfter)
                && !IsQuietFor(m, o.StuckReturnToLaunchAfter),
            static (in ManagerFacts m) => m.WakeUpDelay.Ticks),
        new(HealthReasons.ManagerStuck, HealthLevel.Critical, HealthAdvice.ReturnToLaunch,
            static (in ManagerFacts m, HealthOptions o) => IsQuietFor(m, o.StuckReturnToLaunchAfter),
            static (in ManagerFacts m) => m.WakeUpDelay.Ticks),
    ];

    private static readonly HealthRule<VehicleFacts>[] OfVehicle =
    [
        new(HealthReasons.NoAutopilot, HealthLevel.Warning, HealthAdvice.None,
            static (in VehicleFacts v, HealthOptions _) => v.State.SystemId == 0,
            static (in VehicleFacts _) => 0),
        new(HealthReasons.AutopilotLost, HealthLevel.Critical, HealthAdvice.ReturnToLaunch,
            static (in VehicleFacts v, HealthOptions o) => v.State.SystemId != 0 && !v.IsReplayOver
                && (!v.State.IsConnected || v.HeartbeatAge > o.AutopilotTimeout),
            static (in VehicleFacts v) => v.State.LastHeartbeatTime.Ticks,
            isAdvisedAfterwards: true),
        new(HealthReasons.AutopilotCritical, HealthLevel.Critical, HealthAdvice.None,
            static (in VehicleFacts v, HealthOptions _) => v.State.SystemStatus
                is MavState.Critical or MavState.Emergency or MavState.FlightTermination,
            static (in VehicleFacts v) => (long)v.State.SystemStatus),
        new(HealthReasons.CommandsUnanswered, HealthLevel.Warning, HealthAdvice.None,
            static (in VehicleFacts v, HealthOptions _) => v.State.IsConnected && v.Requests.Unanswered > 0
                && v.Requests.Accepted == 0 && v.Requests.Refused == 0,
            static (in VehicleFacts v) => v.Requests.Unanswered),
        new(HealthReasons.BatteryCritical, HealthLevel.Critical, HealthAdvice.Land,
            static (in VehicleFacts v, HealthOptions o) => v.State.BatteryTime is not null
                && v.State.BatteryRemaining <= o.BatteryCriticalFraction,
            static (in VehicleFacts v) => Percent(v.State.BatteryRemaining)),
        new(HealthReasons.BatteryLow, HealthLevel.Warning, HealthAdvice.ReturnToLaunch,
            static (in VehicleFacts v, HealthOptions o) => v.State.BatteryTime is not null
                && v.State.BatteryRemaining <= o.BatteryLowFraction
                && v.State.BatteryRemaining > o.BatteryCriticalFraction,
            static (in VehicleFacts v) => Percent(v.State.BatteryRemaining)),
        new(HealthReasons.WindHigh, HealthLevel.Warning, HealthAdvice.ReturnToLaunch,
            static (in VehicleFacts v, HealthOptions o) => v.WindHighFor >= o.WindHighAfter,
            static (in VehicleFacts v) => (long)Math.Round(v.State.WindMetresPerSecond)),
    ];

    private static readonly HealthRule<CameraFacts>[] OfCamera =
    [
        new(HealthReasons.CameraSilent, HealthLevel.Warning, HealthAdvice.ReturnToLaunch,
            static (in CameraFacts c, HealthOptions o) => c.Status.HasCamera && c.Status.Mode == ImagingMode.Search
                && c.QuietFor > o.CameraSilentAfter,
            static (in CameraFacts c) => c.Status.LastFrameTime?.Ticks ?? -1),
        new(HealthReasons.DetectorFault, HealthLevel.Warning, HealthAdvice.None,
            static (in CameraFacts c, HealthOptions o) => c.DetectorFaultAge < o.RecentWindow,
            static (in CameraFacts c) => c.DetectorFaults),
    ];

    private static readonly HealthRule<LinkFacts>[] OfLinks =
    [
        new(HealthReasons.LinkDown, HealthLevel.Critical, HealthAdvice.None,
            static (in LinkFacts l, HealthOptions _) => l.State == LinkState.Failed
                || (l.State == LinkState.Ended && !l.IsRecorded),
            static (in LinkFacts l) => (long)l.State),
        new(HealthReasons.LinkSilent, HealthLevel.Warning, HealthAdvice.None,
            static (in LinkFacts l, HealthOptions o) => l.State == LinkState.Silent
                || (l.State == LinkState.Waiting && l.MonitoredFor > o.FirstFrameTimeout),
            static (in LinkFacts l) => (long)l.State),
        new(HealthReasons.FramesDropped, HealthLevel.Warning, HealthAdvice.None,
            static (in LinkFacts l, HealthOptions _) => l.HasDroppedRecently,
            static (in LinkFacts l) => l.FramesDropped),
        new(HealthReasons.SignaturesRejected, HealthLevel.Warning, HealthAdvice.None,
            static (in LinkFacts l, HealthOptions _) => l.HasRejectedRecently,
            static (in LinkFacts l) => l.SignaturesRejected),
    ];

    /// <summary>
    /// Whether a manager works, as our heartbeat claims: it runs, did not fault lately and begins its units of work in
    /// time.
    /// </summary>
    public static bool IsAlive(in ManagerFacts manager, HealthOptions options)
        => IsRunning(manager) && !Matches(OfManagers, manager, options);

    public static void Evaluate(in ManagerFacts manager, HealthOptions options, List<HealthFinding> findings)
        => Evaluate(OfManagers, manager, manager.Name, options, findings);

    public static void Evaluate(in VehicleFacts vehicle, HealthOptions options, List<HealthFinding> findings)
        => Evaluate(OfVehicle, vehicle, subject: null, options, findings);

    public static void Evaluate(in CameraFacts camera, HealthOptions options, List<HealthFinding> findings)
        => Evaluate(OfCamera, camera, subject: null, options, findings);

    public static void Evaluate(in LinkFacts link, HealthOptions options, List<HealthFinding> findings)
        => Evaluate(OfLinks, link, link.Name, options, findings);

    private static void Evaluate<T>(
        HealthRule<T>[] rules, in T facts, string? subject, HealthOptions options, List<HealthFinding> findings)
        where T : struct
    {
        foreach (HealthRule<T> rule in rules)
        {
            if (rule.Condition(facts, options))
            {
                findings.Add(new HealthFinding(
                    rule.Reason, rule.Level, subject, rule.Figure(facts), rule.Advice, rule.IsAdvisedAfterwards));
            }
        }
    }

    private static bool Matches<T>(HealthRule<T>[] rules, in T facts, HealthOptions options)
        where T : struct
    {
        foreach (HealthRule<T> rule in rules)
        {
            if (rule.Condition(facts, options))
                return true;
        }

        return false;
    }

    private static bool IsQuietFor(in ManagerFacts manager, TimeSpan longer)
        => IsRunning(manager) && manager.QuietFor > manager.WakeUpDelay + longer;

    // Before its first unit of work a manager is "starting"; one that never begins it counts as stuck too.
    private static bool IsRunning(in ManagerFacts manager)
        => manager.State is ManagerState.Running or ManagerState.Starting;

    // Rounded down; autopilots report whole per cent, and 0.29 * 100 is slightly less than 29.
    private static long Percent(double fraction) => (long)Math.Floor((fraction * 100) + 1e-9);
}
