using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Findings as text. Called only when they have changed.</summary>
internal static class HealthText
{
    public static string? Of(IReadOnlyList<HealthFinding> findings)
        => findings.Count == 0
            ? null
            : string.Join("; ", findings.OrderByDescending(f => f.Level).ThenBy(f => f.Reason).Select(Describe));

    /// <summary>One finding as text.</summary>
    public static string Of(in HealthFinding finding) => Describe(finding);

    private static string Describe(HealthFinding finding) => finding.Reason switch
    {
        HealthReasons.ManagerFaulted =>
            Invariant($"manager {finding.Subject} faulted ({finding.Figure} faults so far)"),
        HealthReasons.ManagerStuck =>
            Invariant($"manager {finding.Subject} is stuck (it should run every {Seconds(finding.Figure)} s)"),
        HealthReasons.ManagerHangs => Invariant($"manager {finding.Subject} hangs (since {Seconds(finding.Figure)} s)"),
        HealthReasons.NoAutopilot => "no autopilot detected yet",
        HealthReasons.AutopilotLost => Invariant($"autopilot lost (last heartbeat at {Seconds(finding.Figure)} s)"),
        HealthReasons.AutopilotCritical => $"autopilot reports {(MavState)finding.Figure}",
        HealthReasons.BatteryCritical => Invariant($"battery nearly empty ({finding.Figure} %)"),
        HealthReasons.BatteryLow => Invariant($"battery low ({finding.Figure} %)"),
        HealthReasons.LinkDown when finding.Figure == (long)LinkState.Failed => $"link {finding.Subject} failed",
        HealthReasons.LinkDown => $"link {finding.Subject} was closed by the other end",
        HealthReasons.LinkSilent when finding.Figure == (long)LinkState.Waiting =>
            $"link {finding.Subject}: nothing received yet",
        HealthReasons.LinkSilent => $"link {finding.Subject} is silent",
        HealthReasons.FramesDropped => Invariant($"link {finding.Subject} dropped frames ({finding.Figure} so far)"),
        HealthReasons.SignaturesRejected => Invariant(
            $"link {finding.Subject}: {finding.Figure} frames rejected, not signed with our key or not in time"),
        HealthReasons.CommandsUnanswered => Invariant(
            $"the autopilot answers no command ({finding.Figure} so far): it may sign its link, or receive nothing"),
        HealthReasons.CameraSilent when finding.Figure < 0 => "the camera has delivered no picture yet",
        HealthReasons.CameraSilent =>
            Invariant($"the camera delivers no pictures (last at {Seconds(finding.Figure)} s)"),
        HealthReasons.DetectorFault => Invariant($"the target detector is at fault ({finding.Figure} times so far)"),
        HealthReasons.WindHigh => Invariant($"wind too strong ({finding.Figure} m/s)"),
        _ => finding.Reason.ToString(),
    };

    private static string Seconds(long ticks)
        => new TimeSpan(ticks).TotalSeconds.ToString("0.0", CultureInfo.InvariantCulture);

    private static string Invariant(FormattableString text) => FormattableString.Invariant(text);
}
