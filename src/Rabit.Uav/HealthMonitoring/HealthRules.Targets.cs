using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// Times of pictures and poses are judged by where the same targets are reported in different passes, and by the round
// trip of the link; what follows from wrong ones by the tracks and the revisits.
internal static partial class HealthRules
{
    // 0.3 m at 6 m/s: the noise of a position. Three standard deviations are added, so that chance does not reach it.
    private const double OffsetWarning = 0.05;

    // 1.8 m at 6 m/s, 3.6 m between the two directions: more than a gate of Sensor Fusion lets pass for one target.
    private const double OffsetLimit = 0.3;
    private const double OffsetSigmas = 3;

    // Half of a round trip of 350 ms by the square root of 3.
    private const double PoseTimeErrorWarning = 0.1;

    // What a figure of CameraClockOffset is of; the rest of it are milliseconds in steps of ten.
    private const int FigureStep = 10;
    private const long OfLink = 0;
    private const long OfTimes = 1;
    private const long OfTimesOrMount = 2;

    private const int MaxNotConfirmed = 8;
    private const int MaxRevisitsFailed = 2;

    private static readonly TimeSpan OffsetDwell = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan NotConfirmedDwell = TimeSpan.FromSeconds(5);

    public static readonly HealthRule<TargetFacts>[] OfTargets =
    [
        new(HealthReasons.CameraClockOffset, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in TargetFacts t, HealthOptions _) => !IsOff(t, OffsetWarning)
                && t.PoseTimeErrorSeconds > PoseTimeErrorWarning,
            ClearDwell = static _ => NotConfirmedDwell,
            Figure = static (in TargetFacts t) => Milliseconds(t.RoundTripSeconds / 2) + OfLink,
            Text = static f => DescribeOffset(f.Figure),
            Condition = static _ => $"the times of poses are uncertain by {Number(PoseTimeErrorWarning)} s (one "
                + "standard deviation), by half of the link's shortest round trip",
            End = static _ => $"less for {Seconds(NotConfirmedDwell)}",
            Why = "which way takes how long is not observable; the stated covariances of targets include it",
        },
        new(HealthReasons.CameraClockOffset, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in TargetFacts t, HealthOptions _) => IsOff(t, OffsetWarning),
            Until = static (in TargetFacts t, HealthOptions _)
                => !(Math.Abs(t.CameraClock.OffsetSeconds) > OffsetWarning),
            Dwell = static _ => OffsetDwell,
            Figure = static (in TargetFacts t) => OffsetFigure(t),
            Condition = static _ => "the passes over the same targets show that pictures and poses are more than "
                + $"{Number(OffsetWarning)} s apart, by {Number(OffsetSigmas)} standard deviations",
            End = static _ => $"{Number(OffsetWarning)} s or less",
            Why = "0.3 m at 6 m/s, the noise of a position; where a mount that is off in pitch would show the same, the "
                + "text says so",
        },
        new(HealthReasons.CameraClockOffset, HealthLevel.Critical, HealthAdvice.ReturnToLaunch)
        {
            Supersedes = HealthReasons.CameraClockOffset,
            When = static (in TargetFacts t, HealthOptions _) => IsOff(t, OffsetLimit),
            Until = static (in TargetFacts t, HealthOptions _)
                => !(Math.Abs(t.CameraClock.OffsetSeconds) > OffsetLimit),
            Dwell = static _ => OffsetDwell,
            Figure = static (in TargetFacts t) => OffsetFigure(t),
            Condition = static _ => $"the same, more than {Number(OffsetLimit)} s",
            End = static _ => $"{Number(OffsetLimit)} s or less",
            Why = "1.8 m at 6 m/s, and twice that between two directions: one target becomes several",
        },
        new(HealthReasons.TargetsNotConfirmed, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in TargetFacts t, HealthOptions _)
                => (t.NotConfirmed >= MaxNotConfirmed && t.NotConfirmed > 2 * t.Confirmed)
                    || (t.RevisitsFailed >= MaxRevisitsFailed && t.RevisitsFailed > t.Revisits),
            Dwell = static _ => NotConfirmedDwell,
            ClearDwell = static _ => NotConfirmedDwell,
            Figure = static (in TargetFacts t) => t.NotConfirmed,
            Text = static f
                => $"targets not seen again where they were ({f.Figure} tracks): camera clock or mount may be wrong",
            Condition = static _ => $"{MaxNotConfirmed} tracks or more are tentative or lost, and more than twice the "
                + $"confirmed ones; or {MaxRevisitsFailed} revisits or more, and the most of them, saw no target",
            End = static _ => $"no longer for {Seconds(NotConfirmedDwell)}",
            Why = "a wrong time or mount makes several tracks of a target, each seen from one direction only",
        },
    ];

    private static bool IsOff(in TargetFacts t, double limit)
        => t.CameraClock.IsKnown
            && Math.Abs(t.CameraClock.OffsetSeconds) - (OffsetSigmas * t.CameraClock.ErrorSeconds) > limit;

    private static long OffsetFigure(in TargetFacts t)
        => Milliseconds(t.CameraClock.OffsetSeconds) + (t.CameraClock.ExcludesMount ? OfTimes : OfTimesOrMount);

    private static FormattableString DescribeOffset(long figure)
    {
        long milliseconds = figure / FigureStep * FigureStep;
        return (figure % FigureStep) switch
        {
            OfLink => $"times of poses are up to {milliseconds} ms off (delay of the link)",
            OfTimes => $"times of pictures and poses are {milliseconds} ms apart (camera clock or delay of the link)",
            _ => $"times of pictures and poses are {milliseconds} ms apart, or the mount is off in pitch (looks alike)",
        };
    }

    // A figure that changed with every pass would be another finding each time: steps of ten.
    private static long Milliseconds(double seconds) => (long)Math.Round(Math.Abs(seconds) * 100) * FigureStep;
}
