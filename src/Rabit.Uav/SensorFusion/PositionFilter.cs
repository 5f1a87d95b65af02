using Rabit.Geodesy;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// Kalman filter of a target that stands: its position on the ground, north and east, metres. It has no velocity: what
/// the reports of one pass are off together would look like one, and put the target elsewhere by the next pass. A plain
/// value: a copy is a filter of its own.
/// </summary>
internal struct PositionFilter(double north, double east, HorizontalCovariance covariance)
{
    public double North { get; private set; } = north;

    public double East { get; private set; } = east;

    /// <summary>How uncertain the position is.</summary>
    public HorizontalCovariance Covariance { get; private set; } = covariance;

    /// <summary>What a measured position is against the expected one.</summary>
    public readonly Innovation Expect(double north, double east, HorizontalCovariance covariance)
        => new(north - North, east - East, Covariance + covariance);

    /// <summary>Takes a measurement in; in which order they come does not matter.</summary>
    public void Update(double north, double east, HorizontalCovariance covariance)
    {
        Innovation innovation = Expect(north, east, covariance);
        (HorizontalCovariance p, HorizontalCovariance s) = (Covariance, innovation.Covariance);
        double determinant = (s.NorthNorth * s.EastEast) - (s.NorthEast * s.NorthEast);
        double northToNorth = ((p.NorthNorth * s.EastEast) - (p.NorthEast * s.NorthEast)) / determinant;
        double eastToNorth = ((p.NorthEast * s.NorthNorth) - (p.NorthNorth * s.NorthEast)) / determinant;
        double northToEast = ((p.NorthEast * s.EastEast) - (p.EastEast * s.NorthEast)) / determinant;
        double eastToEast = ((p.EastEast * s.NorthNorth) - (p.NorthEast * s.NorthEast)) / determinant;
        North += (northToNorth * innovation.North) + (eastToNorth * innovation.East);
        East += (northToEast * innovation.North) + (eastToEast * innovation.East);

        // K R, which is P - K P without its difference of nearly equal numbers.
        HorizontalCovariance r = covariance;
        Covariance = new HorizontalCovariance(
            (northToNorth * r.NorthNorth) + (eastToNorth * r.NorthEast),
            (northToNorth * r.NorthEast) + (eastToNorth * r.EastEast),
            (northToEast * r.NorthEast) + (eastToEast * r.EastEast));
    }
}
