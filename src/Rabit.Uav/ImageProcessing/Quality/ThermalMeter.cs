using System;

namespace Rabit.Uav.ImageProcessing.Quality;

/// <summary>
/// Measures a picture of 16-bit counts over the grid of <see cref="PictureMeter"/>: detail at one and eight pixels, and
/// a thumbnail that two pictures are compared by. Fixed memory, no allocation; for one thread.
/// </summary>
internal sealed class ThermalMeter
{
    private const int CoarseLag = 8;

    private readonly ComparedThumbnail _thumbnail = new();

    /// <summary>Mean square of the difference of neighbours, square counts: noise for the most part.</summary>
    public double NeighbourDifference { get; private set; }

    /// <summary>
    /// How much more pixels differ that are eight apart than neighbours do, mean square, square counts: the ground.
    /// White noise adds nothing to it, but for what chance makes of it.
    /// </summary>
    public double CoarseDetail { get; private set; }

    /// <summary>The coldest pixel of the grid, counts.</summary>
    public int Coldest { get; private set; }

    /// <summary>The warmest pixel of the grid, counts.</summary>
    public int Warmest { get; private set; }

    /// <summary>Measures a picture; its thumbnail stays until the next one.</summary>
    /// <param name="counts">Row by row; at least width x height.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    public void Measure(ReadOnlySpan<ushort> counts, int width, int height)
    {
        int step = ComparedThumbnail.StepFor(width, height);
        int lag = Math.Min(CoarseLag, Math.Min(width, height) / 4);
        (double near, double far) = (0, 0);
        (Coldest, Warmest) = (ushort.MaxValue, 0);
        _thumbnail.Clear();
        for (int row = 1; row + lag < height && row + 1 < height; row += step)
        {
            for (int column = 1; column + lag < width && column + 1 < width; column += step)
            {
                int at = (row * width) + column;
                int count = counts[at];
                _thumbnail.Add(count);
                (Coldest, Warmest) = (Math.Min(Coldest, count), Math.Max(Warmest, count));
                near += Square(counts[at + 1] - count) + Square(counts[at + width] - count);
                far += Square(counts[at + lag] - count) + Square(counts[at + (lag * width)] - count);
            }
        }

        int pixels = Math.Max(1, _thumbnail.Count);
        NeighbourDifference = near / (2 * pixels);
        CoarseDetail = Math.Max(0, (far / (2 * pixels)) - NeighbourDifference);
    }

    /// <summary>Takes the picture that was measured last as the one that later ones are compared with.</summary>
    public void KeepAsReference() => _thumbnail.KeepAsReference();

    /// <inheritdoc cref="ComparedThumbnail.DifferenceFromReference"/>
    public double DifferenceFromReference() => _thumbnail.DifferenceFromReference();

    private static double Square(double value) => value * value;
}
