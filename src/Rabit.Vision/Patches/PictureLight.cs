using System;

namespace Rabit.Vision;

/// <summary>
/// The light of a picture: how bright the ground is in each of its tiles, and the tint of all of it, which is undone.
/// Measured on one pixel of 16. For one thread; allocates nothing.
/// </summary>
public sealed class PictureLight
{
    /// <summary>Tiles across, and down.</summary>
    internal const int Tiles = 8;

    private const int Step = 4;

    // Ground is not bluer or more violet than this, and not redder, as a part of its green; what is, is tinted.
    private const double MaxBlue = 1.0;
    private const double MinBlue = 0.55;
    private const double MaxRed = 1.25;
    private const double MinRed = 0.75;

    // A tile that is brighter is filled by one bright thing: its ground is taken to be like the rest.
    private const double MaxTileLevel = 1.5;

    private readonly int[] _tile = new int[256];
    private readonly int[] _red = new int[256];
    private readonly int[] _green = new int[256];
    private readonly int[] _blue = new int[256];
    private readonly byte[] _levels = new byte[Tiles * Tiles];
    private int _width = 1;
    private int _height = 1;

    /// <summary>What red is to be multiplied by.</summary>
    public double RedGain { get; private set; } = 1;

    /// <summary>What blue is to be multiplied by.</summary>
    public double BlueGain { get; private set; } = 1;

    /// <summary>Median of the brightness of all the picture, 0 to 255.</summary>
    public int Level { get; private set; }

    /// <summary>Measures a picture.</summary>
    /// <param name="pixels">Red, green, blue, row by row.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <exception cref="ArgumentException">The buffer is too small for the size.</exception>
    public void Measure(byte[] pixels, int width, int height)
    {
        PixelBuffer.Check(pixels, width, height);
        (_width, _height) = (width, height);
        Array.Clear(_red, 0, 256);
        Array.Clear(_green, 0, 256);
        Array.Clear(_blue, 0, 256);
        for (int tile = 0; tile < Tiles * Tiles; tile++)
            _levels[tile] = (byte)MeasureTile(pixels, tile % Tiles, tile / Tiles);
        (double red, double green, double blue) =
            (Math.Max(1, Median(_red)), Math.Max(1, Median(_green)), Math.Max(1, Median(_blue)));
        Level = (int)green;
        for (int tile = 0; tile < _levels.Length; tile++)
            _levels[tile] = (byte)Math.Min(_levels[tile], MaxTileLevel * Level);
        RedGain = Math.Min(Math.Max(red / green, MinRed), MaxRed) / (red / green);
        BlueGain = Math.Min(Math.Max(blue / green, MinBlue), MaxBlue) / (blue / green);
    }

    /// <summary>The median of the brightness in the tile of a pixel, 0 to 255.</summary>
    /// <param name="column">Of the picture that was measured.</param>
    /// <param name="row">Of the picture that was measured.</param>
    public int LevelAt(int column, int row)
        => _levels[(row * Tiles / _height * Tiles) + (column * Tiles / _width)];

    internal int LevelOfTile(int across, int down) => _levels[(down * Tiles) + across];

    private static int Median(int[] histogram)
    {
        int all = 0;
        foreach (int count in histogram)
            all += count;
        (int sum, int value) = (0, 0);
        while (value < 255 && 2 * (sum += histogram[value]) < all)
            value++;
        return value;
    }

    private int MeasureTile(byte[] pixels, int across, int down)
    {
        Array.Clear(_tile, 0, 256);
        int right = (across + 1) * _width / Tiles;
        for (int row = down * _height / Tiles; row < (down + 1) * _height / Tiles; row += Step)
        {
            for (int column = across * _width / Tiles; column < right; column += Step)
            {
                int at = ((row * _width) + column) * 3;
                _red[pixels[at]]++;
                _green[pixels[at + 1]]++;
                _blue[pixels[at + 2]]++;
                _tile[(pixels[at] + (2 * pixels[at + 1]) + pixels[at + 2]) / 4]++;
            }
        }

        return Median(_tile);
    }
}
