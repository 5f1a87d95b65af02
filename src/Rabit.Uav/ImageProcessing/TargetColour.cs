using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// One colour that targets have, and what still counts as it. Light and shade change how bright a thing is, but not its hue, and hardly
/// how pure it is; so hue is judged narrowly, purity against that of the nominal colour, and brightness only where it is too dark to tell.
/// </summary>
internal sealed class TargetColour
{
    // How far from its nominal hue; the nearest two, red and orange, are 27 degrees apart.
    private const double HueWindowDegrees = 13;

    // A mix of the colour with grass at the edge of a panel, rust and clay are less pure than that.
    private const double LeastPurity = 0.8;

    // The same for the difference between the strongest and the weakest channel, which also falls in the shade.
    private const double LeastChroma = 0.52;

    private readonly double _hueDegrees;
    private readonly double _saturation;
    private readonly double _chroma;

    private TargetColour(TargetColours colour, int red, int green, int blue)
    {
        Colour = colour;
        (_hueDegrees, _saturation, _chroma) = Describe(red, green, blue);
    }

    /// <summary>All of them, with the nominal values that <see cref="TargetColours"/> states.</summary>
    public static TargetColour[] All { get; } =
    [
        new(TargetColours.Red, 205, 28, 32),
        new(TargetColours.Orange, 242, 112, 18),
        new(TargetColours.Blue, 28, 72, 205),
        new(TargetColours.Yellow, 243, 214, 28),
        new(TargetColours.Magenta, 212, 36, 150),
    ];

    public TargetColours Colour { get; }

    /// <summary>Whether a pixel may be of this colour.</summary>
    public bool Holds(double red, double green, double blue)
    {
        (double hue, double saturation, double chroma) = Describe(red, green, blue);
        return HueDistance(hue) <= HueWindowDegrees && saturation >= LeastPurity * _saturation && chroma >= LeastChroma * _chroma;
    }

    /// <summary>How near a colour is to the nominal one, whatever the light: 1 is the same, 0.6 the edge of what still counts.</summary>
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

    // Hue, saturation and chroma (A. R. Smith, "Color gamut transform pairs", SIGGRAPH 1978), of channels from 0 to 255.
    private static (double HueDegrees, double Saturation, double Chroma) Describe(double red, double green, double blue)
    {
        double most = Math.Max(red, Math.Max(green, blue));
        double chroma = most - Math.Min(red, Math.Min(green, blue));
        if (chroma <= 0)
            return (0, 0, 0);
        double sixth = most == red ? (green - blue) / chroma
            : most == green ? 2 + ((blue - red) / chroma)
            : 4 + ((red - green) / chroma);
        return ((sixth < 0 ? sixth + 6 : sixth) * 60, chroma / most, chroma);
    }
}
