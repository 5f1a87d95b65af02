using System;
using Rabit.Uav.CameraGeometry;
using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Divides a picture into parts in which a pixel reaches about equally far on the ground: one where the camera points
/// down. Fixed memory; one thread.
/// </summary>
internal sealed class ScaleParts
{
    private const int Columns = 8;
    private const int Rows = 6;

    // A template is found at scales so much off, either way.
    private const double MaxOff = 1.13;

    // From the finest on; what is coarser than all of them is too far away to be searched.
    private const int MaxParts = 8;

    private readonly GroundScale[] _scales = new GroundScale[Columns * Rows];
    private readonly double[] _sides = new double[Columns * Rows];
    private readonly ScalePart[] _parts = new ScalePart[MaxParts];
    private int _count;

    public ReadOnlySpan<ScalePart> Found => new(_parts, 0, _count);

    public void Find(in PictureGroundScale ground, int width, int height)
    {
        double finest = double.MaxValue;
        for (int i = 0; i < _sides.Length; i++)
        {
            _sides[i] = TryScale(ground, i, width, height) ? Math.Sqrt(_scales[i].PixelArea) : 0;
            if (_sides[i] > 0)
                finest = Math.Min(finest, _sides[i]);
        }

        _count = 0;
        double from = finest;
        while (_count < MaxParts && from < double.MaxValue)
            from = Add(from, width, height);
    }

    // In the middle of a tile; of one that is searched in part, at a corner.
    private bool TryScale(in PictureGroundScale ground, int tile, int width, int height)
    {
        for (int i = -1; i < 4; i++)
        {
            double across = (tile % Columns) + (i < 0 ? 0.5 : i % 2);
            double down = (tile / Columns) + (i < 0 ? 0.5 : i / 2);
            if (ground.TryAt(
                (across * width / Columns) - 0.5, (down * height / Rows) - 0.5, out _scales[tile]))
                return true;
        }

        return false;
    }

    /// <summary>Adds the part from a side of a pixel on.</summary>
    /// <returns>The smallest side of what is left; the largest number where nothing is.</returns>
    private double Add(double from, int width, int height)
    {
        double to = from * MaxOff * MaxOff;
        (int left, int top, int right, int bottom) = (Columns, Rows, -1, -1);
        double rest = double.MaxValue;
        for (int i = 0; i < _sides.Length; i++)
        {
            if (_sides[i] > to)
                rest = Math.Min(rest, _sides[i]);
            if (_sides[i] < from || _sides[i] > to)
                continue;
            (left, right) = (Math.Min(left, i % Columns), Math.Max(right, i % Columns));
            (top, bottom) = (Math.Min(top, i / Columns), Math.Max(bottom, i / Columns));
        }

        ref ScalePart part = ref _parts[_count++];
        (part.Left, part.Top) = ((double)left * width / Columns, (double)top * height / Rows);
        (part.Right, part.Bottom) =
            (((right + 1.0) * width / Columns) - 1, ((bottom + 1.0) * height / Rows) - 1);
        part.Scale = Middle(from, to, left + right + 1, top + bottom + 1);
        return rest;
    }

    // Of the tile of the part that is nearest to its middle; the middle is given doubled.
    private PlaneScale Middle(double from, double to, int column, int row)
    {
        (int best, int least) = (0, int.MaxValue);
        for (int i = 0; i < _sides.Length; i++)
        {
            if (_sides[i] < from || _sides[i] > to)
                continue;
            int x = (2 * (i % Columns)) + 1 - column;
            int y = (2 * (i / Columns)) + 1 - row;
            int distance = (x * x) + (y * y);
            if (distance < least)
                (best, least) = (i, distance);
        }

        // The shape of a pixel on the ground as in the middle, its size that of the part.
        double factor = Math.Sqrt(from * Math.Min(to, MaxSide(from, to))) / _sides[best];
        ref readonly GroundScale scale = ref _scales[best];
        return new PlaneScale(
            scale.NorthByColumn * factor, scale.NorthByRow * factor, scale.EastByColumn * factor,
            scale.EastByRow * factor);
    }

    private double MaxSide(double from, double to)
    {
        double max = from;
        foreach (double side in _sides)
        {
            if (side <= to)
                max = Math.Max(max, side);
        }

        return max;
    }
}
