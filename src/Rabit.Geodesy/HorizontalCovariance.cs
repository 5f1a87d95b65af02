using System;

namespace Rabit.Geodesy;

/// <summary>Covariance of a horizontal position, square metres, axes north and east. A plain value.</summary>
/// <param name="NorthNorth">Variance along north.</param>
/// <param name="NorthEast">Covariance of north and east.</param>
/// <param name="EastEast">Variance along east.</param>
/// <example>
/// <code>
/// var covariance = new HorizontalCovariance(4, 0, 1);                  // 2 m along north, 1 m along east
/// Console.WriteLine(covariance.HalfMajorAxis95Metres);                 // 4.9
/// Console.WriteLine(covariance.Contains95(northMetres: 3, eastMetres: 0));   // True
/// </code>
/// </example>
public readonly record struct HorizontalCovariance(double NorthNorth, double NorthEast, double EastEast)
{
    // Chi-square with two degrees of freedom: -2 ln(1 - 0.95).
    private const double ChiSquare95 = 5.991464547107979;

    /// <summary>Half the long axis of the ellipse that holds the truth with 95 %, metres.</summary>
    public double HalfMajorAxis95Metres => Math.Sqrt(ChiSquare95 * MaxVariance);

    /// <summary>Half the short axis of that ellipse, metres.</summary>
    public double HalfMinorAxis95Metres => Math.Sqrt(ChiSquare95 * Math.Max(0, NorthNorth + EastEast - MaxVariance));

    /// <summary>Direction of its long axis, clockwise from north, -90 to 90 degrees.</summary>
    public Angle MajorAxis => Angle.FromRadians(0.5 * Math.Atan2(2 * NorthEast, NorthNorth - EastEast));

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
    public bool Contains95(double northMetres, double eastMetres)
        => MahalanobisSquared(northMetres, eastMetres) <= ChiSquare95;

    /// <summary>
    /// Squared Mahalanobis distance of a point; infinite for a covariance that is not positive definite.
    /// </summary>
    /// <param name="northMetres">The point against the estimate, north.</param>
    /// <param name="eastMetres">The point against the estimate, east.</param>
    public double MahalanobisSquared(double northMetres, double eastMetres)
    {
        double determinant = (NorthNorth * EastEast) - (NorthEast * NorthEast);
        if (!(determinant > 0))
            return double.PositiveInfinity;
        return ((EastEast * northMetres * northMetres) - (2 * NorthEast * northMetres * eastMetres)
            + (NorthNorth * eastMetres * eastMetres)) / determinant;
    }

    /// <summary>As its 95 % ellipse: 4.9 m x 2.45 m at 0°.</summary>
    public override string ToString()
        => FormattableString.Invariant(
            $"{HalfMajorAxis95Metres:0.##} m x {HalfMinorAxis95Metres:0.##} m at {MajorAxis.Degrees:0.#}°");
}
