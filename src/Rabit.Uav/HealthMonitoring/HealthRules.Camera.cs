using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// The camera and the detector are judged by what Image Processing reports.
internal static partial class HealthRules
{
    // Three of the last four pictures: one that is bad by chance does not bring it back.
    private const double PicturesUsableMargin = 0.2;

    public static readonly HealthRule<CameraFacts>[] OfCamera =
    [
        new(HealthReasons.CameraSilent, HealthLevel.Warning, HealthAdvice.ReturnToLaunch)
        {
            When = static (in CameraFacts c, HealthOptions o) => c.Status.HasCamera
                && c.Status.Mode != ImagingMode.Off && c.QuietFor > o.CameraSilentAfter,
            Figure = static (in CameraFacts c) => c.Status.LastFrameTime?.Ticks ?? -1,
            Text = static f => f.Figure < 0
                ? (FormattableString)$"the camera has delivered no picture yet"
                : $"the camera delivers no pictures (last at {Seconds(f.Figure)} s)",
            Condition = static o => "there is a camera, a search is on, and no picture came for "
                + Seconds(o.CameraSilentAfter),
            End = static _ => "its next picture, or the search is over",
            Why = "six pictures at 2 Hz; a search without pictures finds nothing",
        },
        new(HealthReasons.PicturesUnusable, HealthLevel.Warning, HealthAdvice.Hold)
        {
            When = static (in CameraFacts c, HealthOptions o) => IsUnusable(c, o),
            Until = static (in CameraFacts c, HealthOptions o) => c.Status.Mode == ImagingMode.Follow
                || !(c.Status.UsableShare < o.PicturesUsableFraction + PicturesUsableMargin),
            Dwell = static o => o.PicturesUnusableAfter,
            ClearDwell = static o => o.PicturesUnusableAfter,
            Figure = static (in CameraFacts c) => c.UnusableFigure,
            Text = static f => $"pictures: {f.Figure % CameraFacts.CauseUnit} % {CauseOf(f.Figure)}",
            Condition = static o
                => $"{PercentText(o.PicturesUsableFraction)} or less of the last pictures of a search can be used, and "
                    + "most of the others have one cause: black, white, saturated, of one colour, frozen, covered, "
                    + "defocused, motion-blurred, too coarse, with repeated numbers, without pose, not of the ground, "
                    + "not searched",
            End = static o => $"{PercentText(o.PicturesUsableFraction + PicturesUsableMargin)} or more for "
                + $"{Seconds(o.PicturesUnusableAfter)}, or the search is over, or a target is followed",
            Why = "a search whose pictures cannot be used finds nothing. A few bad ones, which gaps are flown over for,"
                + " are no fault of the camera: with the window of 1.5 s of the share this is found within 3 s at 2 Hz."
                + " What passes by itself, a cloud of dust or a driver that starts again, is waited for. A target that"
                + " is followed would be gone meanwhile: it is lost without usable pictures, and the search goes on",
        },
        new(HealthReasons.PicturesUnusable, HealthLevel.Warning, HealthAdvice.ReturnToLaunch)
        {
            Supersedes = HealthReasons.PicturesUnusable,
            When = static (in CameraFacts c, HealthOptions o)
                => c.UnusableFor >= o.PicturesUnusableReturnAfter && IsUnusable(c, o),
            Figure = static (in CameraFacts c) => c.UnusableFigure,
            Condition = static o => $"that holds for {Seconds(o.PicturesUnusableReturnAfter)} in all, without 30 s of "
                + "usable pictures in between",
            End = static _ => "usable pictures, or the search is over",
            Why = "a cover or a broken lens does not pass by itself, and the battery is used meanwhile",
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

    private static bool IsUnusable(in CameraFacts c, HealthOptions o)
        => c.Status.Mode != ImagingMode.Follow && c.Status.UsableShare <= o.PicturesUsableFraction;

    private static string CauseOf(long figure)
        => PictureQualityText.Of((PictureQuality)(figure / CameraFacts.CauseUnit));
}
