using System;

namespace Rabit.Vision;

/// <summary>
/// The temperature of the ground in a thermal picture: medians of tiles, between which it is interpolated, and the
/// noise of a pixel. It follows slow changes, also the shading of the lens; a step of the whole picture, as after the
/// camera's calibration, changes nothing. Memory that is used again; one thread.
/// </summary>
internal sealed class ThermalBackground
{
    private const int MinTile = 12;
    private const int MaxSamples = 256;

    // Of a normal distribution: its median absolute value by its standard deviation; the difference of two has the
    // square root of two times that.
    private const double MedianOfDifference = 0.6745 * 1.41421356;

    private readonly ushort[] _samples = new ushort[MaxSamples];
    private readonly int[] _differences = new int[ushort.MaxValue + 1];
    private float[] _tiles = [];
    private float[] _level = [];
    private int _columns;
    private int _rows;

    /// <summary>One standard deviation of a pixel, counts.</summary>
    public double Noise { get; private set; }

    /// <summary>Computes it.</summary>
    /// <param name="pixels">Counts, row by row.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="maxSide">Of what shall not count as ground, pixels.</param>
    public void Set(ReadOnlySpan<ushort> pixels, int width, int height, double maxSide)
    {
        Noise = FindNoise(pixels, width, height);
        int tile = (int)Math.Max(MinTile, Math.Min(2 * maxSide, Math.Max(width, height)));
        _columns = Math.Max(1, width / tile);
        _rows = Math.Max(1, height / tile);
        if (_tiles.Length < _columns * _rows)
            _tiles = new float[_columns * _rows];
        for (int i = 0; i < _columns * _rows; i++)
            _tiles[i] = Median(pixels, width, height, i % _columns, i / _columns);
        if (_level.Length < width)
            _level = new float[width];
    }

    /// <summary>The ground of a row; valid until the next call.</summary>
    public ReadOnlySpan<float> Row(int row, int width, int height)
    {
        float y = Place(row, height, _rows, out int top);
        float below = y - top;
        int next = Math.Min(top + 1, _rows - 1);
        for (int column = 0; column < width; column++)
        {
            float x = Place(column, width, _columns, out int left);
            float right = x - left;
            int beside = Math.Min(left + 1, _columns - 1);
            float above = _tiles[(top * _columns) + left]
                + (right * (_tiles[(top * _columns) + beside] - _tiles[(top * _columns) + left]));
            float under = _tiles[(next * _columns) + left]
                + (right * (_tiles[(next * _columns) + beside] - _tiles[(next * _columns) + left]));
            _level[column] = above + (below * (under - above));
        }

        return _level.AsSpan(0, width);
    }

    /// <summary>The ground at a place.</summary>
    public double At(double column, double row, int width, int height)
        => Row((int)Math.Round(row), width, height)[(int)Math.Round(column)];

    // In tiles from the centre of the first one; beyond the last centres, what is between the last two goes on.
    private static float Place(int at, int size, int tiles, out int first)
    {
        float place = ((at + 0.5f) * tiles / size) - 0.5f;
        first = Math.Max(0, Math.Min((int)place, tiles - 2));
        return place;
    }

    // By the differences of neighbours: of most of them, the ground is the same.
    private double FindNoise(ReadOnlySpan<ushort> pixels, int width, int height)
    {
        Array.Clear(_differences, 0, _differences.Length);
        int count = 0;
        for (int row = 0; row < height; row++)
        {
            for (int column = 1; column < width; column += 2)
            {
                int at = (row * width) + column;
                int difference = Math.Abs(pixels[at] - pixels[at - 1]);
                _differences[Math.Min(difference, _differences.Length - 1)]++;
                count++;
            }
        }

        // Between whole numbers: as if those of a count lay evenly about it.
        int below = 0;
        int level = 0;
        while (level < _differences.Length - 1 && 2 * (below + _differences[level]) < count)
            below += _differences[level++];
        double part = _differences[level] == 0 ? 0 : ((count / 2.0) - below) / _differences[level];
        double median = level == 0 ? part / 2 : level - 0.5 + part;
        return Math.Max(median / MedianOfDifference, 0.3);   // rounding to whole counts alone
    }

    private float Median(ReadOnlySpan<ushort> pixels, int width, int height, int column, int row)
    {
        int left = column * width / _columns;
        int right = (column + 1) * width / _columns;
        int top = row * height / _rows;
        int bottom = (row + 1) * height / _rows;
        int area = (right - left) * (bottom - top);
        int count = Math.Min(MaxSamples, area);
        for (int i = 0; i < count; i++)
        {
            int at = (int)((long)i * area / count);
            _samples[i] = pixels[((top + (at / (right - left))) * width) + left + (at % (right - left))];
        }

        return InPlaceOrder.Nth(_samples, count, count / 2);
    }
}
