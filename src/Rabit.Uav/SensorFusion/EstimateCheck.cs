using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.SensorFusion.Moving;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// What a track of another vehicle must be to be used. It comes over the air: nothing in it may break a filter.
/// </summary>
internal static class EstimateCheck
{
    private const double MaxAltitudeMetres = 20_000;
    private const double MaxSpeed = 100;

    // One that claims less than a millimetre is not true, and one that is less certain than a track that is taken for
    // lost is of no use.
    private const double MinSigma = 0.001;
    private const double MaxSigma = MovingTargets.LostSigmaMetres;

    private static readonly TimeSpan FutureTolerance = TimeSpan.FromSeconds(1);

    /// <summary>What is wrong with an estimate.</summary>
    /// <param name="estimate">The estimate.</param>
    /// <param name="now">By the clock of the run.</param>
    /// <param name="maxAge">How old it may be.</param>
    public static ReportFault FaultOf(in TrackEstimate estimate, TimeSpan now, TimeSpan maxAge)
    {
        if (estimate.SourceSystemId == 0 || estimate.TrackId <= 0 || estimate.PictureNumber < 0)
            return ReportFault.Identity;
        if (estimate.Time > now + FutureTolerance)
            return ReportFault.Future;

        // Below zero it was before we were switched on: that is what it is for.
        if (estimate.Time < now - maxAge)
            return ReportFault.TooOld;
        GeodeticPosition place = estimate.Position;
        if (!(Math.Abs(place.Latitude.Radians) <= Math.PI / 2 && Math.Abs(place.Longitude.Radians) <= Math.PI
            && Math.Abs(place.AltitudeAmslMetres) <= MaxAltitudeMetres
            && Math.Abs(estimate.VelocityNed.North) <= MaxSpeed && Math.Abs(estimate.VelocityNed.East) <= MaxSpeed))
            return ReportFault.Position;
        if (!IsSized(estimate.Covariance) || !IsSized(estimate.VelocityCovariance))
            return ReportFault.Covariance;
        Span<double> p = stackalloc double[16];
        Span<double> inverse = stackalloc double[16];
        ForeignEstimate.CopyCovariance(estimate, p);
        if (!CovarianceIntersection.TryInvert(p, 4, inverse))
            return ReportFault.Covariance;
        return !estimate.Class.IsNone && estimate.MarkerId is null or (>= 0 and < ushort.MaxValue)
            ? ReportFault.None
            : ReportFault.Description;
    }

    private static bool IsSized(HorizontalCovariance c)
        => Math.Min(c.NorthNorth, c.EastEast) >= MinSigma * MinSigma
            && Math.Max(c.NorthNorth, c.EastEast) <= MaxSigma * MaxSigma;
}
