using System;
using Rabit.Uav.CameraGeometry;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>The size of a blob on the ground.</summary>
internal static class BlobOnGround
{
    // The light of a pixel comes from its whole square, which adds that much variance to each axis.
    private const double PixelVariance = 1.0 / 12;

    /// <summary>Side of a square of its area on the ground, metres.</summary>
    public static double SideMetres(in BlobShape blob, in GroundScale scale) => Math.Sqrt(blob.Area * scale.PixelArea);

    /// <summary>Standard deviations on the ground along its long and its short axis, metres.</summary>
    public static (double Long, double Short) SpreadMetres(in BlobShape blob, in GroundScale scale)
    {
        double xx = Math.Max(0, blob.MomentXX - PixelVariance);
        double yy = Math.Max(0, blob.MomentYY - PixelVariance);
        double nn = Project(
            scale.NorthByColumn, scale.NorthByRow, scale.NorthByColumn, scale.NorthByRow, xx, blob.MomentXY, yy);
        double ne = Project(
            scale.NorthByColumn, scale.NorthByRow, scale.EastByColumn, scale.EastByRow, xx, blob.MomentXY, yy);
        double ee = Project(
            scale.EastByColumn, scale.EastByRow, scale.EastByColumn, scale.EastByRow, xx, blob.MomentXY, yy);
        double mean = (nn + ee) / 2;
        double half = Math.Sqrt((((nn - ee) / 2) * ((nn - ee) / 2)) + (ne * ne));
        return (Math.Sqrt(mean + half), Math.Sqrt(Math.Max(0, mean - half)));
    }

    private static double Project(
        double aByColumn, double aByRow, double bByColumn, double bByRow, double xx, double xy, double yy)
        => (aByColumn * bByColumn * xx) + (((aByColumn * bByRow) + (aByRow * bByColumn)) * xy) + (aByRow * bByRow * yy);
}
