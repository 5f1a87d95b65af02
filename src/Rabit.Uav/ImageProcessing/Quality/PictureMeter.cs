using System;

namespace Rabit.Uav.ImageProcessing.Quality;

/// <summary>
/// Measures a picture in one pass over a grid of pixels: histogram of luma, detail at three distances, flat tiles, and
/// a thumbnail that two pictures are compared by. Fixed memory, no allocation; for one thread.
/// </summary>
/// <remarks>
/// The grid is that of the thumbnail: its cost stays a small part of that of any detector, which reads every pixel.
/// Differences are those of green, which is most of luma.
/// </remarks>
internal sealed class PictureMeter
{
    private const int CoarseLag = 8;
    private const int TilesPerRow = 8;
    private const int TilesPerColumn = 6;
    private const int ClippedLevel = 250;

    // A tile of nothing but noise has a variance of half the mean square difference of neighbours: 1.6 times that is
    // three standard deviations of what 64 pixels give. Where the picture has less noise than one level, JPEG's
    // rounding is what is left. Detail of ground is shared by neighbours, so that the variance is several times that.
    private const double FlatVarianceRatio = 1.6;
    private const double FlatVarianceFloor = 1;

    // Stronger noise than eight levels is none of a camera by day: what varies so much is a pattern.
    private const double MaxFlatVariance = 64;

    private readonly int[] _histogram = new int[256];
    private readonly TileSum[] _tiles = new TileSum[TilesPerRow * TilesPerColumn];
    private readonly ComparedThumbnail _thumbnail = new();
    private Sums _sums;

    private int Pixels => _thumbnail.Count;

    /// <summary>Measures a picture; its thumbnail stays until the next one.</summary>
    /// <param name="pixels">Red, green and blue, row by row; at least width x height x 3 bytes.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    public PictureStatistics Measure(byte[] pixels, int width, int height)
    {
        Array.Clear(_histogram, 0, _histogram.Length);
        Array.Clear(_tiles, 0, _tiles.Length);
        _sums = default;
        _thumbnail.Clear();
        int step = ComparedThumbnail.StepFor(width, height);
        int lag = Math.Min(CoarseLag, Math.Min(width, height) / 4);
        for (int row = 1; row + lag < height && row + 1 < height; row += step)
            MeasureRow(pixels, width, height, row, step, lag);
        return ToStatistics();
    }

    /// <summary>Takes the picture that was measured last as the one that later ones are compared with.</summary>
    public void KeepAsReference() => _thumbnail.KeepAsReference();

    /// <inheritdoc cref="ComparedThumbnail.DifferenceFromReference"/>
    public double DifferenceFromReference() => _thumbnail.DifferenceFromReference();

    private void MeasureRow(byte[] pixels, int width, int height, int row, int step, int lag)
    {
        int stride = 3 * width;
        int tileRow = row * TilesPerColumn / height * TilesPerRow;
        Sums sums = _sums;
        for (int column = 1; column + lag < width; column += step)
        {
            int at = ((row * width) + column) * 3;
            int green = pixels[at + 1];
            int luma = (pixels[at] + (2 * green) + pixels[at + 2] + 2) >> 2;
            _histogram[luma]++;
            _thumbnail.Add(luma);
            int left = pixels[at - 2];
            int right = pixels[at + 4];
            int above = pixels[at + 1 - stride];
            int below = pixels[at + 1 + stride];
            int neighbours = Square(right - green) + Square(green - left) + Square(below - green)
                + Square(green - above);
            sums.Neighbours += neighbours;
            sums.XX += Square(right - left);
            sums.YY += Square(below - above);
            sums.XY += (right - left) * (below - above);
            sums.Coarse += Square(pixels[at + 1 + (3 * lag)] - green) + Square(pixels[at + 1 + (stride * lag)] - green);
            ref TileSum tile = ref _tiles[tileRow + (column * TilesPerRow / width)];
            tile.Count++;
            tile.Green += green;
            tile.Squares += green * green;
            tile.Neighbours += neighbours;
        }

        _sums = sums;
    }

    private PictureStatistics ToStatistics()
    {
        if (Pixels == 0)
            return default;
        double neighbours = _sums.Neighbours / (4.0 * Pixels);
        double xx = _sums.XX / (double)Pixels;
        double yy = _sums.YY / (double)Pixels;
        double xy = _sums.XY / (double)Pixels;
        return new PictureStatistics
        {
            DarkLevel = Level(0.05),
            BrightLevel = Level(0.95),
            ClippedShare = ShareFrom(ClippedLevel),
            NeighbourDifference = neighbours,
            FineDetail = Math.Max(0, ((xx + yy) / 2) - neighbours),
            CoarseDetail = Math.Max(0, (_sums.Coarse / (2.0 * Pixels)) - neighbours),
            DirectedDetail = Math.Sqrt(((xx - yy) * (xx - yy)) + (4 * xy * xy)),
            FlatShare = FlatShare(),
        };
    }

    private int Level(double part)
    {
        int level = 0;
        for (int below = _histogram[0]; below < part * Pixels && level < 255;)
            below += _histogram[++level];
        return level;
    }

    private double ShareFrom(int level)
    {
        int sum = 0;
        for (; level < _histogram.Length; level++)
            sum += _histogram[level];
        return sum / (double)Pixels;
    }

    private double FlatShare()
    {
        (int flat, int tiles) = (0, 0);
        foreach (TileSum tile in _tiles)
        {
            if (tile.Count == 0)
                continue;
            tiles++;
            double mean = tile.Green / (double)tile.Count;
            double variance = (tile.Squares / (double)tile.Count) - (mean * mean);
            double noise = tile.Neighbours / (8.0 * tile.Count);
            if (variance < MaxFlatVariance && variance < (FlatVarianceRatio * noise) + FlatVarianceFloor)
                flat++;
        }

        return tiles == 0 ? 0 : flat / (double)tiles;
    }

    private static int Square(int value) => value * value;

    private struct TileSum
    {
        public int Count;
        public int Green;
        public int Squares;
        public long Neighbours;
    }

    private struct Sums
    {
        public long Neighbours;
        public long XX;
        public long YY;
        public long XY;
        public long Coarse;
    }
}
