using System;

namespace Rabit.Uav.Simulation.Tests.Vision;

/// <summary>
/// A picture that a test draws in linear light: textured ground of two kinds, forms on it, then what a camera makes of
/// it: blur, light, noise, the curve of sRGB, and JPEG.
/// </summary>
internal sealed class DrawnScene
{
    public const int Width = 640;
    public const int Height = 480;

    // A pixel's light is the mean over so many places in each direction.
    private const int Samples = 6;

    private const double ReadNoise = 0.003;
    private const double ShotNoise = 0.0004;

    // How much the light of the ground varies from place to place, over 9 pixels and over 2.3.
    private const double CoarseTexture = 0.2;
    private const double FineTexture = 0.25;

    // Linear light from which on it is clipped softly.
    private const double Knee = 0.8;

    private static readonly (double Red, double Green, double Blue)[] Grounds =
    [
        (0.095, 0.16, 0.045), (0.24, 0.2, 0.1), (0.2, 0.125, 0.075), (0.21, 0.2, 0.175), (0.13, 0.15, 0.07),
    ];

    // The least light of each level of sRGB, and the level at each of so many steps of light.
    private const int Steps = 4096;
    private static readonly double[] MinLight = MinLightOfLevels();
    private static readonly byte[] LevelAt = LevelsAtSteps();

    private readonly Random _random;
    private readonly double[] _light = new double[Width * Height * 3];
    private readonly double[] _blurred = new double[Width * Height * 3];

    public DrawnScene(int seed)
    {
        _random = new Random(seed);
        (double Red, double Green, double Blue) one = Grounds[_random.Next(Grounds.Length)];
        (double Red, double Green, double Blue) other = Grounds[_random.Next(Grounds.Length)];
        var (kind, coarse, fine) = (Noise(90), Noise(9), Noise(2.3));
        for (int i = 0; i < Width * Height; i++)
        {
            (int x, int y) = (i % Width, i / Width);
            double part = Math.Max(0, Math.Min(1, 0.5 + (1.5 * kind(x, y))));
            double light = (1 + (CoarseTexture * coarse(x, y))) * (1 + (FineTexture * fine(x, y)));
            Set(
                3 * i,
                light * (one.Red + (part * (other.Red - one.Red))),
                light * (one.Green + (part * (other.Green - one.Green))),
                light * (one.Blue + (part * (other.Blue - one.Blue))));
        }
    }

    /// <summary>Linear light of a colour in sRGB.</summary>
    public static (double Red, double Green, double Blue) Linear(double red, double green, double blue, double light)
        => (light * Linear(red), light * Linear(green), light * Linear(blue));

    /// <summary>Draws a form.</summary>
    /// <param name="isIn">Whether a column and a row are of it.</param>
    /// <param name="x">Where it is.</param>
    /// <param name="y">Where it is.</param>
    /// <param name="reach">How far it reaches from there.</param>
    /// <param name="colour">Linear light.</param>
    public void Draw(
        Func<double, double, bool> isIn, double x, double y, double reach,
        (double Red, double Green, double Blue) colour)
    {
        ForPixels(x, y, reach, (column, row) =>
        {
            int hits = 0;
            for (int s = 0; s < Samples * Samples; s++)
                hits += isIn(column + PlaceOf(s % Samples), row + PlaceOf(s / Samples)) ? 1 : 0;
            double part = hits / (double)(Samples * Samples);
            int at = ((row * Width) + column) * 3;
            Set(
                at,
                _light[at] + (part * (colour.Red - _light[at])),
                _light[at + 1] + (part * (colour.Green - _light[at + 1])),
                _light[at + 2] + (part * (colour.Blue - _light[at + 2])));
        });
    }

    /// <summary>The picture: blur in pixels, one standard deviation; light by which all is multiplied.</summary>
    public byte[] Finish(double blur, double light, int jpegQuality)
    {
        Blur(blur);
        byte[] pixels = new byte[_light.Length];
        for (int i = 0; i < pixels.Length; i++)
        {
            double value = light * _light[i];
            value += Gauss() * Math.Sqrt((ReadNoise * ReadNoise) + (ShotNoise * value));
            if (value > Knee)
                value = 1 - ((1 - Knee) * Math.Exp(-(value - Knee) / (1 - Knee)));
            pixels[i] = Level(Math.Max(0, value));
        }

        new JpegLoss(Width, Height, jpegQuality).Apply(pixels);
        return pixels;
    }

    private static double PlaceOf(int sample) => ((sample + 0.5) / Samples) - 0.5;

    private static double Linear(double level)
        => level <= 10.3 ? level / 255 / 12.92 : Math.Pow(((level / 255) + 0.055) / 1.055, 2.4);

    // A power for each of a million values took a third of the time.
    private static byte Level(double light)
    {
        int level = LevelAt[Math.Min((int)(Steps * light), Steps - 1)];
        while (level < 255 && light >= MinLight[level + 1])
            level++;
        return (byte)level;
    }

    private static double[] MinLightOfLevels()
    {
        double[] min = new double[256];
        for (int level = 1; level < min.Length; level++)
            min[level] = Linear(level - 0.5);
        return min;
    }

    private static byte[] LevelsAtSteps()
    {
        byte[] levels = new byte[Steps];
        for (int step = 1; step < Steps; step++)
        {
            int level = levels[step - 1];
            while (level < 255 && step / (double)Steps >= MinLight[level + 1])
                level++;
            levels[step] = (byte)level;
        }

        return levels;
    }

    private static void ForPixels(double x, double y, double reach, Action<int, int> action)
    {
        for (int row = Math.Max(0, (int)(y - reach)); row <= Math.Min(Height - 1, (int)(y + reach) + 1); row++)
        {
            int last = Math.Min(Width - 1, (int)(x + reach) + 1);
            for (int column = Math.Max(0, (int)(x - reach)); column <= last; column++)
                action(column, row);
        }
    }

    private double Gauss()
        => Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())) * Math.Cos(2 * Math.PI * _random.NextDouble());

    private void Set(int at, double red, double green, double blue)
        => (_light[at], _light[at + 1], _light[at + 2]) = (red, green, blue);

    // From -1 to 1, of which things have a size of so many pixels.
    private Func<double, double, double> Noise(double size)
    {
        int columns = (int)(Width / size) + 3;
        double[] grid = new double[columns * ((int)(Height / size) + 3)];
        for (int i = 0; i < grid.Length; i++)
            grid[i] = (2 * _random.NextDouble()) - 1;
        return (x, y) =>
        {
            int at = ((int)(y / size) * columns) + (int)(x / size);
            double u = Smooth((x / size) - Math.Floor(x / size));
            double v = Smooth((y / size) - Math.Floor(y / size));
            double top = grid[at] + (u * (grid[at + 1] - grid[at]));
            double bottom = grid[at + columns] + (u * (grid[at + columns + 1] - grid[at + columns]));
            return top + (v * (bottom - top));
        };
    }

    private static double Smooth(double t) => t * t * (3 - (2 * t));

    private void Blur(double sigma)
    {
        int reach = (int)Math.Ceiling(3 * sigma);
        double[] kernel = new double[(2 * reach) + 1];
        double sum = 0;
        for (int i = -reach; i <= reach; i++)
            sum += kernel[i + reach] = Math.Exp(-i * i / (2 * sigma * sigma));
        Blur(_light, _blurred, kernel, sum, across: true);
        Blur(_blurred, _light, kernel, sum, across: false);
    }

    private static void Blur(double[] from, double[] to, double[] kernel, double sum, bool across)
    {
        int reach = kernel.Length / 2;
        for (int i = 0; i < Width * Height; i++)
        {
            (int x, int y) = (i % Width, i / Width);
            (double red, double green, double blue) = (0, 0, 0);
            for (int k = -reach; k <= reach; k++)
            {
                int column = across ? Math.Max(0, Math.Min(Width - 1, x + k)) : x;
                int row = across ? y : Math.Max(0, Math.Min(Height - 1, y + k));
                int at = ((row * Width) + column) * 3;
                double part = kernel[k + reach] / sum;
                red += part * from[at];
                green += part * from[at + 1];
                blue += part * from[at + 2];
            }

            (to[3 * i], to[(3 * i) + 1], to[(3 * i) + 2]) = (red, green, blue);
        }
    }
}
