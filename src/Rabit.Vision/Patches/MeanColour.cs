using System;

namespace Rabit.Vision;

/// <summary>The mean of colours of pixels.</summary>
internal struct MeanColour
{
    // Brightness may vary inside, as by the edge of a shadow; colour may not.
    private const double ShadeInvariance = 0.75;

    public double Red;
    public double Green;
    public double Blue;
    public int Count;

    public void Add(byte[] pixels, int at)
    {
        Red += pixels[at];
        Green += pixels[at + 1];
        Blue += pixels[at + 2];
        Count++;
    }

    /// <summary>Adds the colour of a pixel, whatever its brightness: one of length 1.</summary>
    public void AddHue(byte[] pixels, int at)
    {
        (double red, double green, double blue) = (pixels[at], pixels[at + 1], pixels[at + 2]);
        double length = Math.Sqrt((red * red) + (green * green) + (blue * blue) + 1);
        (Red, Green, Blue) = (Red + (red / length), Green + (green / length), Blue + (blue / length));
        Count++;
    }

    /// <summary>How far a pixel is from it, squared; the length of it is found beforehand.</summary>
    public readonly double SquareTo(byte[] pixels, int at, double length)
    {
        (double red, double green, double blue) =
            (pixels[at] - Red, pixels[at + 1] - Green, pixels[at + 2] - Blue);
        double along = ((red * Red) + (green * Green) + (blue * Blue)) / length;
        return (red * red) + (green * green) + (blue * blue) - (ShadeInvariance * along * along);
    }

    /// <summary>Cosine of the angle to another one: 1 for what differs in brightness alone.</summary>
    public readonly double CosineTo(in MeanColour other)
        => ((Red * other.Red) + (Green * other.Green) + (Blue * other.Blue))
            / Math.Sqrt(Square() * other.Square());

    private readonly double Square() => (Red * Red) + (Green * Green) + (Blue * Blue) + 1e-9;

    /// <summary>Its length, never 0.</summary>
    public readonly double Length() => Math.Sqrt((Red * Red) + (Green * Green) + (Blue * Blue) + 1);

    public readonly MeanColour Mean()
    {
        double count = Math.Max(1, Count);
        return new MeanColour { Red = Red / count, Green = Green / count, Blue = Blue / count, Count = Count };
    }
}
