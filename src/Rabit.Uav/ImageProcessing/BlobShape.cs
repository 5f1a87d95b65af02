using System;

namespace Rabit.Uav.ImageProcessing;

/// <summary>What was measured of a blob below the size of a pixel. A plain value; lengths in pixels.</summary>
internal struct BlobShape
{
    // The light of a pixel comes from its whole square, which spreads everything by that much.
    private const double PixelVariance = 1.0 / 12;

    public double CentreX { get; set; }

    public double CentreY { get; set; }

    /// <summary>Square pixels, with those at the edge counted by the part that is covered.</summary>
    public double Area { get; set; }

    /// <summary>Second moments about the centre, square pixels.</summary>
    public double MomentXX { get; set; }

    public double MomentXY { get; set; }

    public double MomentYY { get; set; }

    /// <summary>The colour inside, channels from 0 to 255.</summary>
    public double Red { get; set; }

    public double Green { get; set; }

    public double Blue { get; set; }

    /// <summary>Side of a square of its area on the ground, metres.</summary>
    public readonly double SideMetres(in GroundScale scale) => Math.Sqrt(Area * scale.PixelArea);

    /// <summary>Standard deviations on the ground along its long and its short axis, metres.</summary>
    public readonly (double Long, double Short) SpreadMetres(in GroundScale scale)
    {
        double xx = Math.Max(0, MomentXX - PixelVariance);
        double yy = Math.Max(0, MomentYY - PixelVariance);
        double nn = Turn(scale.NorthByColumn, scale.NorthByRow, scale.NorthByColumn, scale.NorthByRow, xx, yy);
        double ne = Turn(scale.NorthByColumn, scale.NorthByRow, scale.EastByColumn, scale.EastByRow, xx, yy);
        double ee = Turn(scale.EastByColumn, scale.EastByRow, scale.EastByColumn, scale.EastByRow, xx, yy);
        double mean = (nn + ee) / 2;
        double half = Math.Sqrt((((nn - ee) / 2) * ((nn - ee) / 2)) + (ne * ne));
        return (Math.Sqrt(mean + half), Math.Sqrt(Math.Max(0, mean - half)));
    }

    private readonly double Turn(double aByColumn, double aByRow, double bByColumn, double bByRow, double xx, double yy)
        => (aByColumn * bByColumn * xx) + (((aByColumn * bByRow) + (aByRow * bByColumn)) * MomentXY) + (aByRow * bByRow * yy);
}
