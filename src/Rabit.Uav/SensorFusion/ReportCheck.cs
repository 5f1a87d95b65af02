using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// What a report must be to be used. Reports come over the air too: nothing in them may break a filter.
/// </summary>
internal static class ReportCheck
{
    // A filter has no use for a report that claims a millimetre, or may be a kilometre off.
    private const double MinSigmaMetres = 0.001;
    private const double MaxSigmaMetres = 200;
    private const double MaxSizeMetres = 50;
    private const double MaxAltitudeMetres = 20_000;
    private const int MaxIndex = 10_000;
    private const int MaxMarkerId = ushort.MaxValue - 1;

    // Times of other vehicles are mapped by Communications, from ages.
    private static readonly TimeSpan FutureTolerance = TimeSpan.FromSeconds(1);

    /// <summary>What is wrong with a report.</summary>
    /// <param name="report">The report.</param>
    /// <param name="now">By the clock of the run.</param>
    public static ReportFault FaultOf(in TargetReport report, TimeSpan now)
    {
        if (report.SourceSystemId == 0 || report.PictureNumber < 0 || report.Index is < 0 or > MaxIndex)
            return ReportFault.Identity;
        if (report.Time > now + FutureTolerance)
            return ReportFault.Future;
        if (report.Time < TimeSpan.Zero)
            return ReportFault.TooOld;
        if (!IsPlace(report.Position))
            return ReportFault.Position;
        if (!IsPositiveDefinite(report.Covariance) || !IsNotNegative(report.SystematicCovariance))
            return ReportFault.Covariance;
        bool isDescribed = !report.Class.IsNone
            && report.Score is >= 0 and <= 1
            && report.SizeMetres is > 0 and <= MaxSizeMetres
            && report.MarkerId is null or (>= 0 and <= MaxMarkerId);
        return isDescribed ? ReportFault.None : ReportFault.Description;
    }

    /// <summary>Whether an observation has a number, a time and corners on the earth.</summary>
    public static bool IsValid(in CameraObservation observation, TimeSpan now)
        => observation.SourceSystemId != 0
            && observation.Number >= 0
            && observation.Time >= TimeSpan.Zero && observation.Time <= now + FutureTolerance
            && IsPlace(observation.TopLeft) && IsPlace(observation.TopRight) && IsPlace(observation.BottomRight)
            && IsPlace(observation.BottomLeft);

    private static bool IsPlace(GeodeticPosition place)
        => Math.Abs(place.Latitude.Radians) <= Math.PI / 2
            && Math.Abs(place.Longitude.Radians) <= Math.PI
            && Math.Abs(place.AltitudeAmslMetres) <= MaxAltitudeMetres;

    // Comparisons with NaN are false, so each is written to be true for what is valid.
    private static bool IsPositiveDefinite(HorizontalCovariance c)
        => IsNotNegative(c) && Determinant(c) > 1e-9 * c.NorthNorth * c.EastEast
            && Math.Min(c.NorthNorth, c.EastEast) >= MinSigmaMetres * MinSigmaMetres;

    private static bool IsNotNegative(HorizontalCovariance c)
        => c.NorthNorth is >= 0 and <= MaxSigmaMetres * MaxSigmaMetres
            && c.EastEast is >= 0 and <= MaxSigmaMetres * MaxSigmaMetres
            && Determinant(c) >= -1e-9 * c.NorthNorth * c.EastEast;

    private static double Determinant(HorizontalCovariance c)
        => (c.NorthNorth * c.EastEast) - (c.NorthEast * c.NorthEast);
}
