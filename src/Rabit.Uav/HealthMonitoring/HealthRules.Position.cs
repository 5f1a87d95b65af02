using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// The position is judged in flight: by the satellites, by the estimator, and by whether its sources agree. First the
// vehicle holds; what does not end leads home, or to the ground where there is no position to return by.
internal static partial class HealthRules
{
    // What a figure of PositionFixPoor and of PositionInvalid is of.
    private const long FigureBase = 1000;
    private const long NoFix = 1;
    private const long FewSatellites = 2;
    private const long Dilution = 3;

    // With so many, a poor geometry is what is to be said.
    private const int FewSatellitesText = 6;

    private const long NoPosition = 1;
    private const long Frozen = 2;
    private const long Jumped = 3;

    // Hysteresis: so much better than the limit.
    private const double DilutionMargin = 0.3;
    private const double RatioMargin = 0.2;
    private const double HeightMargin = 0.3;

    // Barometers measure the air of the standard atmosphere: 40 degrees more or less is 15 % of the height.
    private const double HeightErrorPerHeight = 0.15;

    private static readonly TimeSpan FixDwell = TimeSpan.FromSeconds(2);
    private static readonly TimeSpan FixReturnDwell = TimeSpan.FromSeconds(30);
    private static readonly TimeSpan PositionDwell = TimeSpan.OfSeconds(0.5);
    private static readonly TimeSpan PositionLandDwell = TimeSpan.FromSeconds(15);
    private static readonly TimeSpan PositionClearDwell = TimeSpan.FromSeconds(3);
    private static readonly TimeSpan EstimatorDwell = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan EstimatorReturnDwell = TimeSpan.FromSeconds(30);
    private static readonly TimeSpan SlowDwell = TimeSpan.FromSeconds(5);

    public static readonly HealthRule<PositionFacts>[] OfPosition =
    [
        new(HealthReasons.PositionFixPoor, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in PositionFacts p, HealthOptions o) => p.IsInFlight && p.HasFix
                && (p.State.Satellites < o.MinSatellites || p.HorizontalDilution > o.MaxHorizontalDilution),
            Until = static (in PositionFacts p, HealthOptions o) => !p.IsInFlight
                || (p.HasFix && p.State.Satellites > o.MinSatellites
                    && !(p.HorizontalDilution > o.MaxHorizontalDilution - DilutionMargin)),
            Dwell = static _ => SlowDwell,
            ClearDwell = static _ => SlowDwell,
            Figure = static (in PositionFacts p) => FixFigure(p),
            Text = static f => DescribeFix(f.Figure),
            Condition = static o => $"less than {o.MinSatellites} satellites, or HDOP above "
                + Number(o.MaxHorizontalDilution),
            End = static o => $"more than {o.MinSatellites} and below "
                + $"{Number(o.MaxHorizontalDilution - DilutionMargin)} for {Seconds(SlowDwell)}",
            Why = "PX4's EKF2_REQ_NSATS and EKF2_REQ_HDOP; targets are located less well, the flight goes on",
        },
        new(HealthReasons.PositionFixPoor, HealthLevel.Warning, HealthAdvice.Hold)
        {
            Supersedes = HealthReasons.PositionFixPoor,
            When = static (in PositionFacts p, HealthOptions _) => p.IsInFlight && p.ReportsFix && !p.HasFix,
            Dwell = static _ => FixDwell,
            ClearDwell = static _ => PositionClearDwell,
            Figure = static (in PositionFacts p) => FixFigure(p),
            Condition = static _ => "no satellite fix in three dimensions (GPS_RAW_INT), or none reported for 5 s",
            End = static _ => $"a fix for {Seconds(PositionClearDwell)}",
            Why = "the position goes on by inertia for some seconds, and drifts: nothing is searched by it",
        },
        new(HealthReasons.PositionFixPoor, HealthLevel.Critical, HealthAdvice.ReturnToLaunch)
        {
            Supersedes = HealthReasons.PositionFixPoor,
            When = static (in PositionFacts p, HealthOptions _) => p.IsInFlight && p.ReportsFix && !p.HasFix,
            Dwell = static _ => FixReturnDwell,
            ClearDwell = static _ => PositionClearDwell,
            Figure = static (in PositionFacts p) => FixFigure(p),
            Condition = static _ => "the same",
            End = static _ => $"a fix for {Seconds(PositionClearDwell)}",
            Why = "the autopilot's own failsafe acts within 10 s where it has no position: it has one, by other means",
        },
        new(HealthReasons.PositionInvalid, HealthLevel.Critical, HealthAdvice.None)
        {
            When = static (in PositionFacts p, HealthOptions _) => p.IsInFlight && !p.HasPosition,
            ClearDwell = static _ => PositionDwell,
            Figure = static (in PositionFacts _) => NoPosition,
            Text = static f => f.Figure switch
            {
                NoPosition => $"the autopilot reports no valid position",
                Frozen => $"the position stands still while the velocity does not",
                _ => (FormattableString)$"the position jumped by {f.Figure - FigureBase} m",
            },
            Condition = static _ => "no position for 2 s, or none that is one (0/0, not on Earth)",
            End = static _ => $"positions for {Seconds(PositionDwell)}",
            Why = "nothing is commanded meanwhile, and Mission Control lands after 15 s",
        },
        new(HealthReasons.PositionInvalid, HealthLevel.Critical, HealthAdvice.Hold)
        {
            Supersedes = HealthReasons.PositionInvalid,
            When = static (in PositionFacts p, HealthOptions o)
                => p.IsInFlight && (p.IsFrozen || p.DisagreementMetres > o.PositionErrorMetres),
            Until = static (in PositionFacts p, HealthOptions o) => !p.IsInFlight
                || (!p.IsFrozen && !(p.DisagreementMetres > o.PositionErrorMetres / 2)),
            Dwell = static _ => PositionDwell,
            ClearDwell = static _ => PositionClearDwell,
            Figure = static (in PositionFacts p)
                => p.IsFrozen ? Frozen : FigureBase + (long)Math.Round(p.DisagreementMetres / 5) * 5,
            Condition = static o => "the ways of the last 5 s by positions and by velocities end more than "
                + $"{Number(o.PositionErrorMetres)} m from each other: it stands still, or it jumped",
            End = static o => $"less than {Number(o.PositionErrorMetres / 2)} m for {Seconds(PositionClearDwell)}, and "
                + "it has moved by 1 m",
            Why = "estimators correct themselves by 1 to 2 m, one of 2013 by up to 11 m; a single wrong position is gone "
                + "with the next",
        },
        new(HealthReasons.PositionInvalid, HealthLevel.Critical, HealthAdvice.Land)
        {
            Supersedes = HealthReasons.PositionInvalid,
            When = static (in PositionFacts p, HealthOptions _) => p.IsInFlight && p.IsFrozen,
            Dwell = static _ => PositionLandDwell,
            Figure = static (in PositionFacts _) => Frozen,
            Condition = static _ => "it stands still, though the vehicle flew at least so far",
            End = static _ => "it has moved by 1 m",
            Why = "as without a position: home cannot be found by one that stands still",
        },
        new(HealthReasons.EstimatorUnhealthy, HealthLevel.Warning, HealthAdvice.Hold)
        {
            When = static (in PositionFacts p, HealthOptions o) => IsEstimatorBad(p, o.MaxEstimatorRatio),
            Until = static (in PositionFacts p, HealthOptions o)
                => !IsEstimatorBad(p, o.MaxEstimatorRatio - RatioMargin),
            Dwell = static _ => EstimatorDwell,
            ClearDwell = static _ => PositionClearDwell,
            Figure = static (in PositionFacts p) => p.State.HasValidHorizontalPosition ? 1 : 0,
            Text = static f => f.Figure == 1
                ? (FormattableString)$"the autopilot's estimator contradicts its sensors"
                : $"the autopilot's estimator has no position",
            Condition = static o => "a flag of EKF_STATUS_REPORT (ArduPilot) or ESTIMATOR_STATUS (PX4) is missing or "
                + "says glitch, or velocity, position or height are off their measurements by "
                + Number(o.MaxEstimatorRatio),
            End = static o => $"all flags, and below {Number(o.MaxEstimatorRatio - RatioMargin)}, for "
                + Seconds(PositionClearDwell),
            Why = "FS_EKF_THRESH of ArduPilot; recorded flights of both makes stay below 0.5",
        },
        new(HealthReasons.EstimatorUnhealthy, HealthLevel.Critical, HealthAdvice.ReturnToLaunch)
        {
            Supersedes = HealthReasons.EstimatorUnhealthy,
            When = static (in PositionFacts p, HealthOptions o)
                => IsEstimatorBad(p, o.MaxEstimatorRatio) && p.State.HasValidHorizontalPosition,
            Dwell = static _ => EstimatorReturnDwell,
            ClearDwell = static _ => PositionClearDwell,
            Figure = static (in PositionFacts _) => 1,
            Condition = static _ => "the same, with a position",
            End = static _ => $"as above for {Seconds(PositionClearDwell)}",
            Why = "it flies by inertia and drifts; the autopilot's failsafe may not act (a glitch alone is none)",
        },
        new(HealthReasons.EstimatorUnhealthy, HealthLevel.Critical, HealthAdvice.Land)
        {
            Supersedes = HealthReasons.EstimatorUnhealthy,
            When = static (in PositionFacts p, HealthOptions _)
                => p.IsInFlight && p.ReportsEstimator && !p.State.HasValidHorizontalPosition,
            Dwell = static _ => PositionLandDwell,
            ClearDwell = static _ => PositionClearDwell,
            Figure = static (in PositionFacts _) => 0,
            Condition = static _ => "it has no horizontal position",
            End = static _ => $"it has one for {Seconds(PositionClearDwell)}",
            Why = "as without a position; ArduPilot goes on reporting the last one it had",
        },
        new(HealthReasons.HeightInconsistent, HealthLevel.Warning, HealthAdvice.ReturnToLaunch)
        {
            When = static (in PositionFacts p, HealthOptions o)
                => p.IsInFlight && Math.Abs(p.HeightErrorMetres) > HeightLimit(p, o),
            Until = static (in PositionFacts p, HealthOptions o)
                => !p.IsInFlight || !(Math.Abs(p.HeightErrorMetres) > HeightLimit(p, o) * (1 - HeightMargin)),
            Dwell = static _ => SlowDwell,
            ClearDwell = static _ => SlowDwell,
            Figure = static (in PositionFacts p) => (long)Math.Round(p.HeightErrorMetres / 5) * 5,
            Text = static f => $"the height is {f.Figure} m off that of the air pressure",
            Condition = static o => "the height above home and that by the air pressure since take-off "
                + $"(SCALED_PRESSURE) differ by more than {Number(o.HeightErrorMetres)} m and "
                + $"{PercentText(HeightErrorPerHeight)} of the height",
            End = static _ => $"{PercentText(1 - HeightMargin)} of it for {Seconds(SlowDwell)}",
            Why = "the weather changes it by some 5 m in half an hour; what flies lower than it says hits trees",
        },
    ];

    private static bool IsEstimatorBad(in PositionFacts position, double limit)
        => position.IsInFlight && position.ReportsEstimator
            && (position.Navigation.EstimatorFault is not null || position.Navigation.EstimatorRatio >= limit);

    private static double HeightLimit(in PositionFacts position, HealthOptions options)
        => options.HeightErrorMetres + (HeightErrorPerHeight * Math.Abs(position.State.HeightAboveHomeMetres));

    private static long FixFigure(in PositionFacts position)
    {
        if (!position.HasFix)
            return (NoFix * FigureBase) + (long)position.State.GpsFix;
        return position.State.Satellites <= FewSatellitesText || double.IsNaN(position.HorizontalDilution)
            ? (FewSatellites * FigureBase) + position.State.Satellites
            : (Dilution * FigureBase) + Math.Min(FigureBase - 1, (long)Math.Round(position.HorizontalDilution * 10));
    }

    private static FormattableString DescribeFix(long figure) => (figure / FigureBase) switch
    {
        NoFix => $"no satellite fix ({(GpsFixType)(figure % FigureBase)})",
        FewSatellites => $"few satellites ({figure % FigureBase})",
        _ => (FormattableString)$"poor satellite geometry (HDOP {figure % FigureBase / 10.0:0.0})",
    };
}
