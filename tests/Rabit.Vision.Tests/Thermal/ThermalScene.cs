using System;
using System.Runtime.InteropServices;

namespace Rabit.Vision.Tests.Thermal;

/// <summary>
/// A picture of a thermal camera that a test paints: ground that changes slowly, warm things blurred by the lens,
/// noise, defects, the end of the range.
/// </summary>
internal sealed class ThermalScene
{
    public const int Width = 320;
    public const int Height = 256;
    public const double MetresPerPixel = 0.12;
    public const double Noise = 8;

    private const double Blur = 0.8;

    private readonly double[] _counts = new double[Width * Height];
    private readonly Random _random;

    public ThermalScene(int seed)
    {
        _random = new Random(seed);
        for (int i = 0; i < _counts.Length; i++)
        {
            (int x, int y) = (i % Width, i / Width);
            double corner = (((x - 160.0) * (x - 160)) + ((y - 128.0) * (y - 128))) / 40000;
            _counts[i] = 7300 + (60 * Math.Sin(x * 0.02)) + (45 * Math.Sin(y * 0.025)) + (45 * corner);
        }
    }

    /// <summary>A warm rectangle, metres and radians, at a place in pixels.</summary>
    public void Add(double x, double y, double length, double width, double angle, double contrast)
    {
        double reach = (length / MetresPerPixel) + (4 * Blur) + 2;
        (double cos, double sin) = (Math.Cos(angle), Math.Sin(angle));
        for (int row = (int)Math.Max(0, y - reach); row <= Math.Min(Height - 1, y + reach); row++)
        {
            for (int column = (int)Math.Max(0, x - reach); column <= Math.Min(Width - 1, x + reach); column++)
                _counts[(row * Width) + column] += contrast * Covered(column - x, row - y, length, width, cos, sin);
        }
    }

    /// <summary>Sets one pixel, after all else.</summary>
    public void AddDefect(int column, int row, double contrast) => _counts[(row * Width) + column] += contrast;

    /// <summary>The bytes of the picture.</summary>
    /// <param name="gain">Counts for one of the scene: another gain of the camera.</param>
    /// <param name="offset">Added to all counts, as by the camera's calibration.</param>
    /// <param name="most">The end of the sensor's range.</param>
    public byte[] Finish(double gain = 1, double offset = 0, int most = 16383)
    {
        byte[] bytes = new byte[Width * Height * 2];
        Span<ushort> counts = MemoryMarshal.Cast<byte, ushort>(bytes.AsSpan());
        for (int i = 0; i < counts.Length; i++)
        {
            double count = (gain * (_counts[i] + (Noise * Gauss()))) + offset;
            counts[i] = (ushort)Math.Max(0, Math.Min(most, Math.Round(count)));
        }

        return bytes;
    }

    private double Gauss()
        => Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())) * Math.Cos(2 * Math.PI * _random.NextDouble());

    // How much of it the blur of the lens brings to a pixel: its edges are error functions.
    private static double Covered(double x, double y, double length, double width, double cos, double sin)
    {
        double along = (x * cos) + (y * sin);
        double across = (y * cos) - (x * sin);
        return Between(along, length / MetresPerPixel / 2) * Between(across, width / MetresPerPixel / 2);
    }

    private static double Between(double at, double half)
        => Integral((at + half) / Sigma) - Integral((at - half) / Sigma);

    // The pixel's own square blurs too.
    private static double Sigma => Math.Sqrt((Blur * Blur) + (1.0 / 12));

    // Of the normal distribution, by a logistic function that is 0.01 off at most.
    private static double Integral(double at) => 1 / (1 + Math.Exp(-1.702 * at));
}
