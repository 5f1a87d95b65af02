using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// What a report must be to be believed at all. Reports come over the air too: nothing in them may bring a filter down.
/// </summary>
internal static class ReportCheck
{
    // A report that could be a centimetre or a kilometre wrong says nothing that a filter should hear.
    private const double MinSigmaMetres = 0.001;
    private const double MaxSigmaMetres = 200;
    private const double MaxSizeMetres = 50;
    private const double MaxAltitudeMetres = 20_000;
    private const int MaxIndex = 10_000;

    // Clocks of one computer differ by nothing; those of two by what Communications maps them to.
    private static readonly TimeSpan FutureTolerance = TimeSpan.FromSeconds(1);

    /// <summary>Whether a report makes sense.</summary>
    /// <param name="report">The report.</param>
    /// <param name="now">By the clock of the run.</param>
    public static bool IsSound(in TargetReport report, TimeSpan now)
        => report.SourceSystemId != 0
            && report.PictureNumber >= 0
            && report.Index is >= 0 and <= MaxIndex
            && report.Time >= TimeSpan.Zero && report.Time <= now + FutureTolerance
            && IsPlace(report.Position)
            && IsPositiveDefinite(report.Covariance)
            && IsNotNegative(report.SystematicCovariance)
            && IsOneColour(report.Colour)
            && report.Score is >= 0 and <= 1
            && report.SizeMetres is > 0 and <= MaxSizeMetres;

    /// <summary>Whether a look has a number, a time and corners on the earth.</summary>
    public static bool IsSound(in CameraObservation look, TimeSpan now)
        => look.SourceSystemId != 0
            && look.Number >= 0
            && look.Time >= TimeSpan.Zero && look.Time <= now + FutureTolerance
            && IsPlace(look.TopLeft) && IsPlace(look.TopRight) && IsPlace(look.BottomRight) && IsPlace(look.BottomLeft);

    private static bool IsPlace(GeodeticPosition place)
        => Math.Abs(place.Latitude.Radians) <= Math.PI / 2
            && Math.Abs(place.Longitude.Radians) <= Math.PI
            && Math.Abs(place.AltitudeAmslMetres) <= MaxAltitudeMetres;

    // Comparisons with NaN are false, so each is written to be true for what is sound.
    private static bool IsPositiveDefinite(HorizontalCovariance c)
        => IsNotNegative(c) && Determinant(c) > 1e-9 * c.NorthNorth * c.EastEast
            && Math.Min(c.NorthNorth, c.EastEast) >= MinSigmaMetres * MinSigmaMetres;

    private static bool IsNotNegative(HorizontalCovariance c)
        => c.NorthNorth is >= 0 and <= MaxSigmaMetres * MaxSigmaMetres
            && c.EastEast is >= 0 and <= MaxSigmaMetres * MaxSigmaMetres
            && Determinant(c) >= -1e-9 * c.NorthNorth * c.EastEast;

    private static double Determinant(HorizontalCovariance c) => (c.NorthNorth * c.EastEast) - (c.NorthEast * c.NorthEast);

    private static bool IsOneColour(TargetColours colour)
        => colour != TargetColours.None && (colour & ~TargetColours.All) == 0 && (colour & (colour - 1)) == 0;
}
