using System;
using Rabit.Uav.ImageProcessing;

namespace VisionBench;

/// <summary>A target that counts, and what was found of it.</summary>
internal sealed class TargetMatch(ListedTarget target)
{
    public ListedTarget Target { get; } = target;

    /// <summary>Null for a miss.</summary>
    public TargetDetection? Found { get; set; }

    /// <summary>Whether so much of it is overexposed that its colour is lost.</summary>
    public bool IsClipped { get; set; }

    /// <summary>How far the centre is off, pixels.</summary>
    public double Error => Found is { } found
        ? Math.Sqrt(Square(found.CentreX - Target.X) + Square(found.CentreY - Target.Y))
        : double.NaN;

    /// <summary>The squared error by the covariance that the detector gave: 2 in the mean if that is true.</summary>
    public double NormalisedErrorSquared
    {
        get
        {
            if (Found is not { } found)
                return double.NaN;
            (double x, double y) = (found.CentreX - Target.X, found.CentreY - Target.Y);
            PixelCovariance p = found.Covariance;
            double determinant = (p.ColumnColumn * p.RowRow) - Square(p.ColumnRow);
            return ((p.RowRow * x * x) - (2 * p.ColumnRow * x * y) + (p.ColumnColumn * y * y)) / determinant;
        }
    }

    private static double Square(double value) => value * value;
}
