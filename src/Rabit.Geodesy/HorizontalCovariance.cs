using System;

namespace Rabit.Geodesy;

/// <summary>Covariance of a horizontal position, square metres, axes north and east. A plain value.</summary>
/// <param name="northNorth">Variance along north.</param>
/// <param name="northEast">Covariance.</param>
/// <param name="eastEast">Variance along east.</param>
public readonly struct HorizontalCovariance(double northNorth, double northEast, double eastEast)
{
    // Chi-square with two degrees of freedom: -2 ln(1 - 0.95).
    private const double ChiSquare95 = 5.991464547107979;

    /// <summary>Variance along north.</summary>
    public double NorthNorth { get; } = northNorth;

    /// <summary>Covariance.</summary>
    public double NorthEast { get; } = northEast;

    /// <summary>Variance along east.</summary>
    public double EastEast { get; } = eastEast;

    /// <summary>Half the long axis of the ellipse that holds the truth with 95 %, metres.</summary>
    public double HalfMajorAxis95Metres => Math.Sqrt(ChiSquare95 * MaxVariance);

    /// <summary>Half the short axis of that ellipse, metres.</summary>
    public double HalfMinorAxis95Metres => Math.Sqrt(ChiSquare95 * Math.Max(0, NorthNorth + EastEast - MaxVariance));

    /// <summary>Direction of its long axis, radians clockwise from north, -pi/2 to pi/2.</summary>
    public double MajorAxisRadians => 0.5 * Math.Atan2(2 * NorthEast, NorthNorth - EastEast);

    private double MaxVariance
    {
        get
        {
            double mean = (NorthNorth + EastEast) / 2;
            double half = (NorthNorth - EastEast) / 2;
            return mean + Math.Sqrt((half * half) + (NorthEast * NorthEast));
        }
    }

    /// <summary>Sum of two covariances, of independent errors.</summary>
    public static HorizontalCovariance operator +(HorizontalCovariance a, HorizontalCovariance b)
        => new(a.NorthNorth + b.NorthNorth, a.NorthEast + b.NorthEast, a.EastEast + b.EastEast);

    /// <summary>Whether the 95 % ellipse around an estimate holds a point.</summary>
    /// <param name="northMetres">The point against the estimate, north.</param>
    /// <param name="eastMetres">The point against the estimate, east.</param>
    public bool Holds95(double northMetres, double eastMetres) => MahalanobisSquared(northMetres, eastMetres) <= ChiSquare95;

    /// <summary>Squared Mahalanobis distance of a point; infinite for a covariance that is not positive definite.</summary>
    /// <param name="northMetres">The point against the estimate, north.</param>
    /// <param name="eastMetres">The point against the estimate, east.</param>
    public double MahalanobisSquared(double northMetres, double eastMetres)
    {
        double determinant = (NorthNorth * EastEast) - (NorthEast * NorthEast);
        if (!(determinant > 0))
            return double.PositiveInfinity;
        return ((EastEast * northMetres * northMetres) - (2 * NorthEast * northMetres * eastMetres) + (NorthNorth * eastMetres * eastMetres)) / determinant;
    }
}
