using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// The camera and the detector are judged by what Image Processing reports.
internal static partial class HealthRules
{
    public static readonly HealthRule<CameraFacts>[] OfCamera =
    [
        new(HealthReasons.CameraSilent, HealthLevel.Warning, HealthAdvice.ReturnToLaunch)
        {
            When = static (in CameraFacts c, HealthOptions o) => c.Status.HasCamera
                && c.Status.Mode == ImagingMode.Search && c.QuietFor > o.CameraSilentAfter,
            Figure = static (in CameraFacts c) => c.Status.LastFrameTime?.Ticks ?? -1,
            Text = static f => f.Figure < 0
                ? (FormattableString)$"the camera has delivered no picture yet"
                : $"the camera delivers no pictures (last at {Seconds(f.Figure)} s)",
            Condition = static o => "there is a camera, a search is on, and no picture came for "
                + Seconds(o.CameraSilentAfter),
            End = static _ => "its next picture, or the search is over",
            Why = "six pictures at 2 Hz; a search without pictures finds nothing",
        },
        new(HealthReasons.DetectorFault, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in CameraFacts c, HealthOptions o) => c.DetectorFaultAge < o.RecentWindow,
            Figure = static (in CameraFacts c) => c.DetectorFaults,
            Text = static f => $"the target detector is at fault ({f.Figure} times so far)",
            Condition = static _ => "the target detector threw, gave invalid detections or exceeded its time budget",
            End = static o => $"{Seconds(o.RecentWindow)} without another fault",
            Why = "one picture more or less decides nothing",
        },
    ];
}
