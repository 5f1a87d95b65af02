using Rabit.Geodesy;

namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>A standing point that was looked at. A plain value.</summary>
/// <param name="position">Where it stands.</param>
/// <param name="covariance">How uncertain that is, with all that is not known of the biases: of the vehicle's position too.</param>
/// <param name="looks">How often it was seen.</param>
public readonly struct BiasPoint(GeodeticPosition position, HorizontalCovariance covariance, int looks)
{
    /// <summary>Where it stands.</summary>
    public GeodeticPosition Position { get; } = position;

    /// <summary>How uncertain that is, with all that is not known of the biases: of the vehicle's position too.</summary>
    public HorizontalCovariance Covariance { get; } = covariance;

    /// <summary>How often it was seen.</summary>
    public int Looks { get; } = looks;
}
