using System;

namespace Rabit.Vision;

/// <summary>
/// Between levels, 0 to 255, and the light that they stand for, 0 to 1: the curve of sRGB (IEC 61966-2-1). What haze
/// adds can only be taken away from light.
/// </summary>
public static class LinearLight
{
    /// <summary>The light of a level.</summary>
    /// <param name="level">0 to 255; less is taken for 0.</param>
    public static double Of(double level)
    {
        double part = Math.Max(0, level) / 255;
        return part <= 0.04045 ? part / 12.92 : Math.Pow((part + 0.055) / 1.055, 2.4);
    }

    /// <summary>The level of a light, 0 to 255; more than 255 for more than the brightest.</summary>
    /// <param name="light">1 for the brightest; less than 0 is taken for 0.</param>
    public static double ToLevel(double light)
        => 255 * (light <= 0.0031308 ? 12.92 * Math.Max(0, light) : (1.055 * Math.Pow(light, 1 / 2.4)) - 0.055);
}
