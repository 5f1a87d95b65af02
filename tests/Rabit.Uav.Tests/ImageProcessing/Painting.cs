using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Tests.ImageProcessing;

/// <summary>A picture that a test paints: grass with noise, and rectangles with soft edges on it.</summary>
internal sealed class Painting
{
    public const int Width = 640;
    public const int Height = 480;

    // A pixel's light is the mean over so many places in each direction.
    private const int Samples = 8;

    // Patches of lighter and darker grass.
    private static readonly Lazy<double[]> Patches = new(() =>
    {
        var patches = new double[Width * Height];
        for (int i = 0; i < patches.Length; i++)
        {
            (int x, int y) = (i % Width, i / Width);
            patches[i] = (12 * Math.Sin(x * 0.05)) + (10 * Math.Sin((y * 0.07) + (x * 0.02)));
        }

        return patches;
    });

    private readonly GaussianNoise _noise;

    public Painting(int seed, double noise = 3)
    {
        _noise = new GaussianNoise(new Random(seed));
        Noise = noise;
        double[] patches = Patches.Value;
        for (int i = 0; i < patches.Length; i++)
        {
            double blade = 8 * _noise.Next();
            Set(3 * i, 86 + patches[i] + blade, 112 + patches[i] + blade, 56 + (0.6 * (patches[i] + blade)));
        }
    }

    public byte[] Pixels { get; } = new byte[Width * Height * 3];

    public double Noise { get; }

    public static (double Red, double Green, double Blue) Nominal(TargetClassName targetClass)
        => targetClass.ToString() switch
        {
            "red" => (205, 28, 32),
            "orange" => (242, 112, 18),
            "blue" => (28, 72, 205),
            "yellow" => (243, 214, 28),
            "magenta" => (212, 36, 150),
            _ => throw new ArgumentOutOfRangeException(nameof(targetClass)),
        };

    public void Panel(TargetClassName targetClass, double x, double y, double side, double angle, double light = 1)
    {
        (double red, double green, double blue) = Nominal(targetClass);
        Rectangle((red * light, green * light, blue * light), x, y, side, side, angle);
    }

    /// <summary>Paints a rectangle; the centre of the top left pixel is (0, 0).</summary>
    public void Rectangle(
        (double Red, double Green, double Blue) colour, double x, double y, double length, double width, double angle)
    {
        (double cos, double sin) = (Math.Cos(angle), Math.Sin(angle));
        int reach = (int)Math.Ceiling((length + width) / 2) + 1;
        for (int row = Math.Max(0, (int)y - reach); row <= Math.Min(Height - 1, (int)y + reach); row++)
        {
            for (int column = Math.Max(0, (int)x - reach); column <= Math.Min(Width - 1, (int)x + reach); column++)
            {
                // Where it is all inside or all outside, half a pixel's diagonal away from each side.
                double depth = Math.Min(
                    (length / 2) - Math.Abs(((column - x) * cos) + ((row - y) * sin)),
                    (width / 2) - Math.Abs(((row - y) * cos) - ((column - x) * sin)));
                int hits = depth > 0.71 ? Samples * Samples : 0;
                for (int s = 0; s < Samples * Samples && Math.Abs(depth) <= 0.71; s++)
                {
                    double dx = column - x + (((s % Samples) + 0.5) / Samples) - 0.5;
                    double dy = row - y + (((s / Samples) + 0.5) / Samples) - 0.5;
                    if (Math.Abs((dx * cos) + (dy * sin)) <= length / 2
                        && Math.Abs((dy * cos) - (dx * sin)) <= width / 2)
                        hits++;
                }

                Mix(column, row, colour, hits / (double)(Samples * Samples));
            }
        }
    }

    /// <summary>Paints a square of cells in two colours, beside each other: 1 x 2 cells or 2 x 2.</summary>
    public void TwoColours(
        (double Red, double Green, double Blue) first, (double Red, double Green, double Blue) second,
        double x, double y, double side, double angle, bool isChequered)
    {
        (double cos, double sin) = (Math.Cos(angle), Math.Sin(angle));
        int across = isChequered ? 2 : 1;
        for (int cell = 0; cell < 2 * across; cell++)
        {
            (int column, int row) = (cell % across, cell / across);
            double u = isChequered ? (column - 0.5) * side / 2 : 0;
            double v = (row - 0.5) * side / 2;
            Rectangle(
                (column + row) % 2 == 0 ? first : second, x + (u * cos) - (v * sin), y + (u * sin) + (v * cos),
                side / across, side / 2, angle);
        }
    }

    /// <summary>Adds the noise of the sensor, last of all.</summary>
    public byte[] Finish()
    {
        for (int i = 0; i < Pixels.Length; i++)
            Pixels[i] = ToByte(Pixels[i] + (Noise * _noise.Next()));
        return Pixels;
    }

    private static byte ToByte(double value) => (byte)Math.Max(0, Math.Min(255, Math.Round(value)));

    private void Mix(int x, int y, (double Red, double Green, double Blue) colour, double part)
    {
        int at = ((y * Width) + x) * 3;
        Set(
            at,
            Pixels[at] + (part * (colour.Red - Pixels[at])),
            Pixels[at + 1] + (part * (colour.Green - Pixels[at + 1])),
            Pixels[at + 2] + (part * (colour.Blue - Pixels[at + 2])));
    }

    private void Set(int at, double red, double green, double blue)
        => (Pixels[at], Pixels[at + 1], Pixels[at + 2]) = (ToByte(red), ToByte(green), ToByte(blue));
}
