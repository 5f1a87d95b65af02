using System;
using Rabit.Uav.CameraGeometry;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// How much ground a pixel shows at most, around each place of a picture: what is too small by that is too small.
/// Fixed memory; for one thread.
/// </summary>
internal sealed class PixelAreas
{
    private const int Columns = 8;
    private const int Rows = 6;

    // A pixel reaches furthest on the ground at one of the corners of a part; the lens may bend its middle a little
    // more.
    private const double Slack = 1.5;

    // Pixels that differ by no more are taken for the largest of them.
    private const double MaxRatio = 2;

    private readonly double[] _areas = new double[(Columns + 1) * (Rows + 1)];
    private int _width;
    private int _height;
    private double _largest;

    /// <summary>Measures a picture.</summary>
    public void Measure(in DetectorInput input)
    {
        (_width, _height) = (input.Width, input.Height);
        (double smallest, _largest) = (double.PositiveInfinity, 0);
        for (int corner = 0; corner < 4; corner++)
        {
            double area = AreaAt(input, corner % 2, 1, corner / 2, 1);
            (smallest, _largest) = (Math.Min(smallest, area), Math.Max(_largest, area));
        }

        if (_largest <= MaxRatio * smallest && _largest < double.PositiveInfinity)
            return;
        _largest = double.PositiveInfinity;
        for (int i = 0; i < _areas.Length; i++)
            _areas[i] = AreaAt(input, i % (Columns + 1), Columns, i / (Columns + 1), Rows);
    }

    /// <summary>What no pixel around a place exceeds, square metres; 0 where it is not searched.</summary>
    public double MaxAt(in PictureGroundScale ground, double column, double row)
    {
        if (_largest < double.PositiveInfinity)
            return Slack * _largest;
        int first = ((int)(row * Rows / _height) * (Columns + 1)) + (int)(column * Columns / _width);
        double largest = Math.Max(
            Math.Max(_areas[first], _areas[first + 1]),
            Math.Max(_areas[first + Columns + 1], _areas[first + Columns + 2]));
        if (largest < double.PositiveInfinity)
            return Slack * largest;
        return ground.TryAt(column, row, out GroundScale scale) ? Slack * scale.PixelArea : 0;
    }

    // Infinite where the ground is not searched.
    private static double AreaAt(in DetectorInput input, int across, int columns, int down, int rows)
        => input.GroundScale.TryAt(
            across * (input.Width - 1.0) / columns, down * (input.Height - 1.0) / rows, out GroundScale scale)
            ? scale.PixelArea
            : double.PositiveInfinity;
}
