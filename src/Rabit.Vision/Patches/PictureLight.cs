using System;

namespace Rabit.Vision;

/// <summary>
/// The light of a picture: how bright the ground is in each of its tiles, the tint of all of it, and the veil of haze
/// and stray light over it, which are undone. Measured on one pixel of 16. For one thread; allocates nothing.
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

    // Low sun makes ground no redder than this undoes; what is redder still is red soil, on which a yellow panel would
    // be green without that limit.
    private const double MinRedGain = 0.85;

    // Natural logarithm of red by blue: of the median of ground, in 150 generated and real pictures; its standard
    // deviation is 0.15 to 0.2, so little of what a picture differs by is light.
    private const double UsualTint = 0.2;
    private const double LightInTint = 0.1;
    private const double MaxLikelyTint = 0.06;   // the least is -0.05: red is at least 0.75, blue at most 1 of green

    // A tile that is brighter is filled by one bright thing: its ground is taken to be like the rest.
    private const double MaxTileLevel = 1.5;

    // Nor is it brighter by more than the third brightest of those around it and itself: a car fills one or two, while
    // a road goes through three.
    private const double MaxAround = 1.15;
    private const int BrightTiles = 2;

    // The darkest of the pixels, a five hundredth, are deep shade: about half of what comes from there is haze. More
    // than so much light is none, but ground without anything dark.
    private const int DarkestPart = 500;
    private const double VeilInShade = 0.5;
    private const double MaxVeil = 0.06;

    // Of the pixels that are measured so many may glint.
    private const int FewOfWhitest = 4;

    private readonly int[] _tile = new int[256];
    private readonly int[] _red = new int[256];
    private readonly int[] _green = new int[256];
    private readonly int[] _blue = new int[256];
    private readonly int[] _least = new int[256];
    private readonly byte[] _measured = new byte[Tiles * Tiles];
    private readonly byte[] _levels = new byte[Tiles * Tiles];
    private long _count; // of the pixels that were measured
    private int _width = 1;
    private int _height = 1;

    /// <summary>What red is to be multiplied by.</summary>
    public double RedGain { get; private set; } = 1;

    /// <summary>What blue is to be multiplied by.</summary>
    public double BlueGain { get; private set; } = 1;

    /// <summary>What haze adds to red all over the picture: light, 1 for the brightest that it can show.</summary>
    public double RedVeil { get; private set; }

    /// <summary>What haze adds to green, as <see cref="RedVeil"/>.</summary>
    public double GreenVeil { get; private set; }

    /// <summary>What haze adds to blue, as <see cref="RedVeil"/>.</summary>
    public double BlueVeil { get; private set; }

    /// <summary>Median of the brightness of all the picture, 0 to 255.</summary>
    public int Level { get; private set; }

    /// <summary>The level that the least channel of its whitest pixels has, but for a few of them; 0 to 255.</summary>
    internal int Whitest { get; private set; }

    /// <summary>
    /// What the light, with what is undone, is likely to make of red by blue, natural logarithm: ground that is redder
    /// than usual speaks for red light, a little.
    /// </summary>
    internal double LikelyTint { get; private set; }

    /// <summary>Measures a picture.</summary>
    /// <param name="pixels">Red, green, blue, row by row.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <exception cref="ArgumentException">The buffer is too small for the size.</exception>
    public void Measure(byte[] pixels, int width, int height)
    {
        PixelBuffer.Check(pixels, width, height);
        (_width, _height) = (width, height);
        _count = 0;
        Array.Clear(_red, 0, 256);
        Array.Clear(_green, 0, 256);
        Array.Clear(_blue, 0, 256);
        Array.Clear(_least, 0, 256);
        for (int tile = 0; tile < Tiles * Tiles; tile++)
            _levels[tile] = (byte)MeasureTile(pixels, tile % Tiles, tile / Tiles);
        (double red, double green, double blue) =
            (Math.Max(1, Median(_red)), Math.Max(1, Median(_green)), Math.Max(1, Median(_blue)));
        Level = (int)green;
        LimitTiles();
        RedGain = Math.Max(MinRedGain, Math.Min(Math.Max(red / green, MinRed), MaxRed) / (red / green));
        BlueGain = Math.Min(Math.Max(blue / green, MinBlue), MaxBlue) / (blue / green);
        LikelyTint = Math.Min(
            MaxLikelyTint, LightInTint * (Math.Log(red * RedGain / (blue * BlueGain)) - UsualTint));
        Whitest = LevelOfBrightest();
        (RedVeil, GreenVeil, BlueVeil) = (VeilOf(_red, RedGain), VeilOf(_green, 1), VeilOf(_blue, BlueGain));
    }

    /// <summary>
    /// How bright the ground is in the tile of a pixel, 0 to 255: the median of its pixels, but no more than the tiles
    /// around it and the whole picture let ground have.
    /// </summary>
    /// <param name="column">Of the picture that was measured.</param>
    /// <param name="row">Of the picture that was measured.</param>
    public int LevelAt(int column, int row)
        => _levels[(row * Tiles / _height * Tiles) + (column * Tiles / _width)];

    internal int LevelOfTile(int across, int down) => _levels[(down * Tiles) + across];

    /// <summary>A colour of the picture, with its tint undone, without that part of the veil; levels.</summary>
    internal (double Red, double Green, double Blue) Unveil(double red, double green, double blue, double part)
        => (Unveil(red, part * RedVeil), Unveil(green, part * GreenVeil), Unveil(blue, part * BlueVeil));

    private static double Unveil(double level, double veil)
        => veil == 0 ? level : LinearLight.ToLevel(LinearLight.Of(level) - veil);

    private int Median(int[] histogram) => LevelOfPart(histogram, 2, _count);

    private double VeilOf(int[] histogram, double gain)
        => Math.Min(MaxVeil, VeilInShade * LinearLight.Of(gain * LevelOfPart(histogram, DarkestPart, _count)));

    private void LimitTiles()
    {
        _levels.CopyTo(_measured, 0);
        for (int tile = 0; tile < _levels.Length; tile++)
        {
            // Where all around lies in deep shade, a tile may be as bright as the picture.
            double around = Math.Max(Level, MaxAround * ThirdBrightestAround(tile % Tiles, tile / Tiles));
            _levels[tile] = (byte)Math.Min(_levels[tile], Math.Min(around, MaxTileLevel * Level));
        }
    }

    private int ThirdBrightestAround(int across, int down)
    {
        int count = 0;
        Span<byte> levels = stackalloc byte[9];
        for (int row = Math.Max(0, down - 1); row <= Math.Min(Tiles - 1, down + 1); row++)
        {
            for (int column = Math.Max(0, across - 1); column <= Math.Min(Tiles - 1, across + 1); column++)
            {
                byte level = _measured[(row * Tiles) + column];
                int at = count++;
                for (; at > 0 && levels[at - 1] < level; at--)
                    levels[at] = levels[at - 1];
                levels[at] = level;
            }
        }

        return levels[BrightTiles];
    }

    private int LevelOfBrightest()
    {
        (int sum, int value) = (0, 256);
        while (value > 0 && (sum += _least[--value]) < FewOfWhitest)
        {
        }

        return value;
    }

    // The level that one of so many pixels, of all that were measured, do not exceed.
    private static int LevelOfPart(int[] histogram, int part, long all)
    {
        (long sum, int value) = (0, 0);
        while (value < 255 && part * (sum += histogram[value]) < all)
            value++;
        return value;
    }

    private unsafe int MeasureTile(byte[] pixels, int across, int down)
    {
        Array.Clear(_tile, 0, 256);
        (int left, int right) = (across * _width / Tiles, (across + 1) * _width / Tiles);
        int count = 0;
        fixed (byte* begin = pixels)
        fixed (int* tile = _tile, red = _red, green = _green, blue = _blue, least = _least)
        {
            for (int row = down * _height / Tiles; row < (down + 1) * _height / Tiles; row += Step)
            {
                byte* end = begin + (((row * _width) + right) * 3);
                count += (right - left + Step - 1) / Step;
                for (byte* p = begin + (((row * _width) + left) * 3); p < end; p += 3 * Step)
                {
                    red[p[0]]++;
                    green[p[1]]++;
                    blue[p[2]]++;
                    least[Math.Min(p[0], Math.Min(p[1], p[2]))]++;
                    tile[(p[0] + (2 * p[1]) + p[2]) / 4]++;
                }
            }
        }

        _count += count;
        return LevelOfPart(_tile, 2, count);
    }
}
