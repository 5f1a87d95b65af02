using System;
using Rabit.Geodesy;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Size and direction of a blob on the ground.</summary>
internal static class BlobOnGround
{
    // The light of a pixel comes from its whole square, which adds that much variance to each axis.
    private const double PixelVariance = 1.0 / 12;

    // Side of a rectangle by its spread along it.
    private const double RectangleFactor = 3.4641016151377544;

    // Rounder things have a direction by chance; of such that is known worse a person makes nothing.
    private const double MinLongAspect = 1.3;
    private static readonly Angle MinSigma = Angle.FromDegrees(0.3);
    private static readonly Angle MaxSigma = Angle.FromDegrees(12);

    /// <summary>Standard deviations on the ground along its long and its short axis, metres.</summary>
    public static (double Long, double Short) SpreadMetres(in BlobShape blob, in GroundScale scale)
    {
        (double nn, double ne, double ee) = Moments(blob, scale);
        double mean = (nn + ee) / 2;
        double half = Math.Sqrt((((nn - ee) / 2) * ((nn - ee) / 2)) + (ne * ne));
        return (Math.Sqrt(mean + half), Math.Sqrt(Math.Max(0, mean - half)));
    }

    /// <summary>The direction of its long axis; null where it is too round or too small to have one.</summary>
    /// <param name="blob">Its moments.</param>
    /// <param name="scale">Where it lies.</param>
    /// <param name="edgeSigma">How uncertain its outline is, pixels, each of them on its own.</param>
    public static TargetBearing? BearingOf(in BlobShape blob, in GroundScale scale, double edgeSigma)
    {
        (double longSpread, double shortSpread) = SpreadMetres(blob, scale);
        if (!(longSpread >= MinLongAspect * shortSpread))
            return null;

        // Sides of the rectangle with these moments. What shifts the pixels of its long sides turns it.
        double pixel = Math.Sqrt(scale.PixelArea);
        (double length, double width) = (RectangleFactor * longSpread / pixel, RectangleFactor * shortSpread / pixel);
        double byEdge = Math.Sqrt(6 * length) * edgeSigma / ((length * length) - (width * width));
        double sigma = Math.Sqrt((byEdge * byEdge) + (MinSigma.Radians * MinSigma.Radians));
        if (!(sigma <= MaxSigma.Radians))
            return null;
        (double nn, double ne, double ee) = Moments(blob, scale);
        return new TargetBearing(
            Angle.FromRadians(Math.Atan2(2 * ne, nn - ee) / 2), Angle.FromRadians(sigma), BearingSymmetry.HalfTurn);
    }

    private static (double NorthNorth, double NorthEast, double EastEast) Moments(
        in BlobShape blob, in GroundScale scale)
    {
        double xx = Math.Max(0, blob.MomentXX - PixelVariance);
        double yy = Math.Max(0, blob.MomentYY - PixelVariance);
        (double nc, double nr) = (scale.NorthByColumn, scale.NorthByRow);
        (double ec, double er) = (scale.EastByColumn, scale.EastByRow);
        return (
            Project(nc, nr, nc, nr, xx, blob.MomentXY, yy), Project(nc, nr, ec, er, xx, blob.MomentXY, yy),
            Project(ec, er, ec, er, xx, blob.MomentXY, yy));
    }

    private static double Project(
        double aByColumn, double aByRow, double bByColumn, double bByRow, double xx, double xy, double yy)
        => (aByColumn * bByColumn * xx) + (((aByColumn * bByRow) + (aByRow * bByColumn)) * xy) + (aByRow * bByRow * yy);
}
