using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// A link is judged by its state and its counters.
internal static partial class HealthRules
{
    public static readonly HealthRule<LinkFacts>[] OfLinks =
    [
        new(HealthReasons.LinkDown, HealthLevel.Critical, HealthAdvice.None)
        {
            When = static (in LinkFacts l, HealthOptions _) => l.State == LinkState.Failed
                || (l.State == LinkState.Opening && !l.IsOptional)
                || (l.State == LinkState.Ended && !l.IsRecorded),
            Figure = static (in LinkFacts l) => (long)l.State,
            Text = static f => f.Figure == (long)LinkState.Failed
                ? (FormattableString)$"link {f.Subject} failed"
                : f.Figure == (long)LinkState.Opening ? (FormattableString)$"link {f.Subject} is not open, and is tried again"
                : $"link {f.Subject} was closed by the other end",
            Condition = static _ => "it failed, it cannot be opened and is not optional, or the peer closed it; a log that ends is no fault",
            End = static _ => "it is open again",
            Why = "where it is the autopilot's, AutopilotLost follows",
        },
        new(HealthReasons.LinkSilent, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in LinkFacts l, HealthOptions o) => !l.IsOptional
                && (l.State == LinkState.Silent
                    || (l.State == LinkState.Waiting && l.MonitoredFor > o.FirstFrameTimeout)),
            Figure = static (in LinkFacts l) => (long)l.State,
            Text = static f => f.Figure == (long)LinkState.Waiting
                ? (FormattableString)$"link {f.Subject}: nothing received yet"
                : $"link {f.Subject} is silent",
            Condition = static o => $"frames stopped coming, or none came within {Seconds(o.FirstFrameTimeout)}; not of an optional link",
            End = static _ => "its next frame",
            Why = "heartbeats come once a second on a link that works",
        },
        new(HealthReasons.FramesDropped, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in LinkFacts l, HealthOptions _) => l.HasDroppedRecently,
            Figure = static (in LinkFacts l) => l.FramesDropped,
            Text = static f => $"link {f.Subject} dropped frames ({f.Figure} so far)",
            Condition = static _ => "frames were dropped because a queue was full; not what was to go out over a link "
                + "that is silent, which LinkSilent says",
            End = static o => $"{Seconds(o.RecentWindow)} without another",
            Why = "nothing is lost in silence",
        },
        new(HealthReasons.SignaturesRejected, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in LinkFacts l, HealthOptions _) => l.HasRejectedRecently,
            Figure = static (in LinkFacts l) => l.SignaturesRejected,
            Text = static f => $"link {f.Subject}: {f.Figure} frames rejected, not signed with our key or not in time",
            Condition = static _ => "frames on a signed link were rejected: another key, or none, or not in time",
            End = static o => $"{Seconds(o.RecentWindow)} without another",
            Why = "a wrong key shows in nothing else than silence",
        },
        new(HealthReasons.AddressConflict, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in LinkFacts l, HealthOptions _) => l.HasConflictedRecently,
            Figure = static (in LinkFacts l) => l.AddressConflicts,
            Text = static f => $"link {f.Subject}: {f.Figure} frames have our own address or that of our autopilot",
            Condition = static _ => "frames came in that have our own address and are not from us, or that of our "
                + "autopilot, which comes in over another link",
            End = static o => $"{Seconds(o.RecentWindow)} without another",
            Why = "another component with the same ids, two links to one vehicle, or a forged sender: what such frames "
                + "say may not be true",
        },
    ];

    public static readonly HealthRule<RecordingFacts>[] OfRecording =
    [
        new(HealthReasons.RecordingIncomplete, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in RecordingFacts r, HealthOptions _) => r.HasLostRecently,
            Figure = static (in RecordingFacts r) => r.FramesMissing,
            Text = static f => $"the recording misses frames ({f.Figure} so far)",
            Condition = static _ => "frames could not be recorded: the disk is full, gone or too slow",
            End = static o => $"{Seconds(o.RecentWindow)} without another",
            Why = "who looks at the log after the flight must know; the flight does not need it",
        },
    ];
}
