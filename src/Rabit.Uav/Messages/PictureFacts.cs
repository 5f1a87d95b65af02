using System;

namespace Rabit.Uav.Messages;

/// <summary>What was measured of a picture, for people. A plain value.</summary>
public struct PictureFacts
{
    /// <summary>How long it was exposed; zero where the camera does not say it.</summary>
    public TimeSpan Exposure { get; set; }

    /// <summary>Below it lie 5 % of the luma, levels of 255.</summary>
    public int DarkLevel { get; set; }

    /// <summary>Below it lie 95 % of the luma, levels of 255.</summary>
    public int BrightLevel { get; set; }

    /// <summary>Part of the pixels that are overexposed, 0 to 1.</summary>
    public double ClippedShare { get; set; }

    /// <summary>
    /// Fine detail (two pixels apart) by coarse detail (eight apart), without the noise: a blur makes it smaller, and
    /// below 0.06 a picture counts as defocused. NaN where there is no detail.
    /// </summary>
    public double Sharpness { get; set; }

    /// <summary>How many targets the detector found in it; 0 where it was not searched.</summary>
    public int Detections { get; set; }
}
