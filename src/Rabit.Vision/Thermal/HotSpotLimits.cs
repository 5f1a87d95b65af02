namespace Rabit.Vision;

/// <summary>What <see cref="HotSpotFinder"/> takes for a hot spot.</summary>
public struct HotSpotLimits
{
    /// <summary>How much warmer than the ground around it its warmest part must be, counts of the sensor.</summary>
    public double MinContrast { get; set; }

    /// <summary>How much warmer than the ground around it its warmest part must be, by the noise of a pixel.</summary>
    public double MinSigmas { get; set; }

    /// <summary>
    /// Side of the largest spot, pixels: the ground around it is taken from an area several times as wide.
    /// </summary>
    public double MaxSide { get; set; }
}
