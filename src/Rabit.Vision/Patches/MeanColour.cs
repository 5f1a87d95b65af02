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

    /// <summary>How far a pixel is from it, squared; the length of it is found beforehand.</summary>
    public readonly double SquareTo(byte[] pixels, int at, double length)
    {
        (double red, double green, double blue) =
            (pixels[at] - Red, pixels[at + 1] - Green, pixels[at + 2] - Blue);
        double along = ((red * Red) + (green * Green) + (blue * Blue)) / length;
        return (red * red) + (green * green) + (blue * blue) - (ShadeInvariance * along * along);
    }

    /// <summary>Its length, never 0.</summary>
    public readonly double Length() => Math.Sqrt((Red * Red) + (Green * Green) + (Blue * Blue) + 1);

    public readonly MeanColour Mean()
    {
        double count = Math.Max(1, Count);
        return new MeanColour { Red = Red / count, Green = Green / count, Blue = Blue / count, Count = Count };
    }
}
