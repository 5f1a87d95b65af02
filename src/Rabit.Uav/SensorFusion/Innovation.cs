using System;
using Rabit.Geodesy;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// A measured position against the expected one, metres, and how uncertain the difference is. A plain value.
/// </summary>
internal readonly struct Innovation(double north, double east, HorizontalCovariance covariance)
{
    public double North { get; } = north;

    public double East { get; } = east;

    public HorizontalCovariance Covariance { get; } = covariance;

    /// <summary>Squared Mahalanobis distance.</summary>
    public double DistanceSquared => Covariance.MahalanobisSquared(North, East);

    /// <summary>
    /// What pairing them costs: squared distance and logarithm of the determinant, without which a track that knows
    /// nothing would win every report (Bar-Shalom, Li, Kirubarajan, 6.4).
    /// </summary>
    public double Cost => DistanceSquared
        + Math.Log((Covariance.NorthNorth * Covariance.EastEast) - (Covariance.NorthEast * Covariance.NorthEast));

    /// <summary>The density of the Gaussian at this difference, per square metre.</summary>
    public double Likelihood
    {
        get
        {
            HorizontalCovariance s = Covariance;
            double determinant = (s.NorthNorth * s.EastEast) - (s.NorthEast * s.NorthEast);
            return Math.Exp(-0.5 * DistanceSquared) / (2 * Math.PI * Math.Sqrt(determinant));
        }
    }
}
