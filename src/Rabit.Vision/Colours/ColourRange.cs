using System;

namespace Rabit.Vision;

/// <summary>
/// A colour and what still counts as it. Light and shade change how bright a thing is, but not its hue, and hardly its
/// saturation; so the window of hue is narrow, saturation is compared with that of the nominal colour, and brightness
/// counts only where it is too dark to decide. Immutable.
/// </summary>
/// <example>
/// <code>
/// var orange = new ColourRange(242, 112, 18);
/// bool inTheShade = orange.Contains(145, 67, 11);   // true: darker, of the same hue
/// bool grass = orange.Contains(86, 112, 56);        // false
/// </code>
/// </example>
public sealed class ColourRange
{
    // How far from its nominal hue; the nearest two, red and orange, are 27 degrees apart.
    private const double HueWindowDegrees = 13;

    // A mix of the colour with grass at the edge of a panel, rust and clay are less saturated than that.
    private const double MinSaturationRatio = 0.8;

    // The same for the difference between the strongest and the weakest channel, which also falls in the shade.
    private const double MinChromaRatio = 0.52;

    private readonly double _hueDegrees;
    private readonly double _saturation;
    private readonly double _chroma;

    /// <summary>Makes the range around a colour.</summary>
    /// <param name="red">sRGB, 0 to 255.</param>
    /// <param name="green">sRGB, 0 to 255.</param>
    /// <param name="blue">sRGB, 0 to 255.</param>
    public ColourRange(byte red, byte green, byte blue)
    {
        (Red, Green, Blue) = (red, green, blue);
        (_hueDegrees, _saturation, _chroma) = Describe(red, green, blue);
    }

    /// <summary>Red of the colour that it is around, sRGB.</summary>
    public byte Red { get; }

    /// <summary>Green of the colour that it is around, sRGB.</summary>
    public byte Green { get; }

    /// <summary>Blue of the colour that it is around, sRGB.</summary>
    public byte Blue { get; }

    /// <summary>Whether a pixel may be of this colour.</summary>
    /// <param name="red">0 to 255.</param>
    /// <param name="green">0 to 255.</param>
    /// <param name="blue">0 to 255.</param>
    public bool Contains(double red, double green, double blue)
    {
        (double hue, double saturation, double chroma) = Describe(red, green, blue);
        return HueDistance(hue) <= HueWindowDegrees && saturation >= MinSaturationRatio * _saturation
            && chroma >= MinChromaRatio * _chroma;
    }

    /// <summary>
    /// How near a colour is to the nominal one, whatever the light: 1 is the same, 0.6 the edge of what still counts.
    /// </summary>
    /// <param name="red">0 to 255.</param>
    /// <param name="green">0 to 255.</param>
    /// <param name="blue">0 to 255.</param>
    public double Closeness(double red, double green, double blue)
    {
        (double hue, double saturation, _) = Describe(red, green, blue);
        double off = HueDistance(hue) / HueWindowDegrees;
        return Math.Exp(-0.5 * off * off) * Math.Min(1, saturation / _saturation);
    }

    private double HueDistance(double hueDegrees)
    {
        double off = Math.Abs(hueDegrees - _hueDegrees);
        return off > 180 ? 360 - off : off;
    }

    // Hue, saturation and chroma (A. R. Smith, "Color gamut transform pairs", SIGGRAPH 1978), of channels from 0 to
    // 255.
    internal static (double HueDegrees, double Saturation, double Chroma) Describe(
        double red, double green, double blue)
    {
        double max = Math.Max(red, Math.Max(green, blue));
        double chroma = max - Math.Min(red, Math.Min(green, blue));
        if (chroma <= 0)
            return (0, 0, 0);
        double sixth = max == red ? (green - blue) / chroma
            : max == green ? 2 + ((blue - red) / chroma)
            : 4 + ((red - green) / chroma);
        return ((sixth < 0 ? sixth + 6 : sixth) * 60, chroma / max, chroma);
    }
}
