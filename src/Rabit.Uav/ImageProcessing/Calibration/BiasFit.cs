namespace Rabit.Uav.ImageProcessing.Calibration;

/// <summary>How well looks agree with an estimate. A plain value.</summary>
/// <param name="looks">How many were used.</param>
/// <param name="refused">How many were not: not a number, or never above the ground.</param>
/// <param name="residualPixels">Root mean square of what is left, pixels.</param>
/// <param name="normalisedSquare">Mean square of what is left by what it should be; 1 where the stated noise is right.</param>
public readonly struct BiasFit(int looks, int refused, double residualPixels, double normalisedSquare)
{
    /// <summary>How many were used.</summary>
    public int Looks { get; } = looks;

    /// <summary>How many were not: not a number, or no ground there.</summary>
    public int Refused { get; } = refused;

    /// <summary>Root mean square of what is left, pixels.</summary>
    public double ResidualPixels { get; } = residualPixels;

    /// <summary>Mean square of what is left by what it should be; 1 where the stated noise is right.</summary>
    public double NormalisedSquare { get; } = normalisedSquare;
}
