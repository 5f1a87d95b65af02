using Rabit.Geodesy;

namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>Where a target is expected if it is in one of its modes. A plain value.</summary>
/// <param name="Weight">How likely it is in that mode.</param>
/// <param name="North">Metres in the local frame.</param>
/// <param name="East">Metres.</param>
/// <param name="Covariance">Against measurements, without what differs from one to the next.</param>
internal readonly record struct ExpectedPlace(double Weight, double North, double East, HorizontalCovariance Covariance)
{
    /// <summary>A measurement against it.</summary>
    public Innovation Compare(in TrackMeasurement measurement)
        => new(measurement.North - North, measurement.East - East, Covariance + measurement.Covariance);
}
