namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>How well observations agree with an estimate. A plain value.</summary>
/// <param name="Observations">How many were used.</param>
/// <param name="Refused">How many were not: not a number, or no ground there.</param>
/// <param name="ResidualPixels">Root mean square of the residuals, pixels.</param>
/// <param name="NormalisedSquare">
/// Mean square of the residuals by what it should be; 1 where the stated noise is right.
/// </param>
public readonly record struct BiasFit(int Observations, int Refused, double ResidualPixels, double NormalisedSquare);
