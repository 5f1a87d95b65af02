using System;

namespace Rabit.Vision;

/// <summary>
/// How bright the ground is about each pixel, or how colourful: medians of tiles, of which again the median of three by
/// three is taken, between which it is interpolated. Memory that is used again; one thread.
/// </summary>
/// <param name="ofChroma">
/// Whether it is of the difference of the strongest and the weakest channel, instead of red + 2 x green + blue.
/// </param>
internal sealed class GroundLevels(bool ofChroma = false)
{
    // Of chroma few do: it is only compared with what has twice as much.
    private const int MaxSamplesOfChroma = 64;

    private const int MinTile = 16;
    private const int MaxTiles = 256;   // across or down
    private const int MaxSamples = 1024;
    private const int Levels = 1024;    // red + 2 x green + blue

    private readonly int _maxSamples = ofChroma ? MaxSamplesOfChroma : MaxSamples;
    private readonly int[] _histogram = new int[Levels];
    private readonly float[] _nine = new float[9];
    private float[] _medians = [];
    private float[] _tiles = [];
    private float[] _blended = [];
    private float[] _row = [];
    private int _columns;
    private int _rows;

    /// <summary>Measures a picture.</summary>
    /// <param name="pixels">Red, green, blue, row by row.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="tile">Side of a tile, pixels.</param>
    public void Measure(byte[] pixels, int width, int height, double tile)
    {
        double side = Math.Max(MinTile, Math.Max(tile, Math.Max(width, height) / (double)MaxTiles));
        _columns = Math.Max(1, (int)(width / side));
        _rows = Math.Max(1, (int)(height / side));
        if (_tiles.Length < _columns * _rows)
            (_medians, _tiles) = (new float[_columns * _rows], new float[_columns * _rows]);
        if (_row.Length < width)
            (_row, _blended) = (new float[width], new float[MaxTiles]);
        for (int i = 0; i < _columns * _rows; i++)
            _medians[i] = Median(pixels, width, height, i % _columns, i / _columns);
        for (int i = 0; i < _columns * _rows; i++)
            _tiles[i] = MedianOfNine(i % _columns, i / _columns);
    }

    /// <summary>That of the ground at a pixel; of many, <see cref="Row"/> is faster.</summary>
    public float At(int column, int row, int width, int height)
    {
        float y = Place(row, height, _rows, out int top, out int below);
        float x = Place(column, width, _columns, out int left, out int right);
        return Blend(
            Blend(_tiles[(top * _columns) + left], _tiles[(below * _columns) + left], y),
            Blend(_tiles[(top * _columns) + right], _tiles[(below * _columns) + right], y), x);
    }

    /// <summary>That of the ground along a row; valid until the next call.</summary>
    public float[] Row(int row, int width, int height)
    {
        float y = Place(row, height, _rows, out int top, out int below);
        for (int i = 0; i < _columns; i++)
            _blended[i] = Blend(_tiles[(top * _columns) + i], _tiles[(below * _columns) + i], y);

        for (int column = 0; column < width; column++)
        {
            float x = Place(column, width, _columns, out int left, out int right);
            _row[column] = Blend(_blended[left], _blended[right], x);
        }

        return _row;
    }

    /// <summary>What the strongest channel has more than the weakest.</summary>
    public static int ChromaOf(int red, int green, int blue)
        => Math.Max(red, Math.Max(green, blue)) - Math.Min(red, Math.Min(green, blue));

    private static float Blend(float one, float other, float part) => one + (part * (other - one));

    // From the centre of one tile to that of the next; beyond the last centres it stays.
    private static float Place(int at, int size, int tiles, out int first, out int second)
    {
        float place = Math.Max(0, ((at + 0.5f) * tiles / size) - 0.5f);
        first = Math.Min((int)place, tiles - 1);
        second = Math.Min(first + 1, tiles - 1);
        return place - first;
    }

    private float Median(byte[] pixels, int width, int height, int column, int row)
    {
        (int left, int right) = (column * width / _columns, (column + 1) * width / _columns);
        (int top, int bottom) = (row * height / _rows, (row + 1) * height / _rows);
        int step = Math.Max(1, (int)Math.Sqrt((right - left) * (bottom - top) / _maxSamples));
        Array.Clear(_histogram, 0, Levels);
        int count = 0;
        for (int y = top; y < bottom; y += step)
        {
            for (int x = left; x < right; x += step)
            {
                int at = ((y * width) + x) * 3;
                (int red, int green, int blue) = (pixels[at], pixels[at + 1], pixels[at + 2]);
                _histogram[ofChroma ? ChromaOf(red, green, blue) : red + (2 * green) + blue]++;
                count++;
            }
        }

        (int sum, int level) = (0, 0);
        while (level < Levels - 1 && 2 * (sum += _histogram[level]) < count)
            level++;
        return level;
    }

    private float MedianOfNine(int column, int row)
    {
        int count = 0;
        for (int y = row - 1; y <= row + 1; y++)
        {
            for (int x = column - 1; x <= column + 1; x++)
            {
                float value = _medians[(Math.Max(0, Math.Min(y, _rows - 1)) * _columns)
                    + Math.Max(0, Math.Min(x, _columns - 1))];
                int place = count++;
                for (; place > 0 && _nine[place - 1] > value; place--)
                    _nine[place] = _nine[place - 1];
                _nine[place] = value;
            }
        }

        return _nine[4];
    }
}
