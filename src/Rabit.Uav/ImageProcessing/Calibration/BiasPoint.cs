using Rabit.Geodesy;

namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>A static point that was observed. A plain value.</summary>
/// <param name="Position">Where it stands.</param>
/// <param name="Covariance">
/// How uncertain that is, with all that is not known of the biases: of the vehicle's position too.
/// </param>
/// <param name="Observations">How often it was seen.</param>
public readonly record struct BiasPoint(GeodeticPosition Position, HorizontalCovariance Covariance, int Observations);
