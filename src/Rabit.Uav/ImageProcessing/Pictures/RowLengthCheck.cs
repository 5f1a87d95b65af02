using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// Whether the rows of a program's raw pictures are longer or shorter than it is taken for: what is one row below a
/// pixel is like it, and what is elsewhere less so. Of the first pictures, by lengths that programs pad rows to. One
/// thread.
/// </summary>
internal sealed class RowLengthCheck(ProcessCameraOptions options)
{
    private const int Pictures = 5;
    private const int Step = 7;   // samples; one that has no part in the lengths of rows

    // With the right length all others are less alike, but for a slanted pattern; bare ground, dim and out of focus, is
    // alike everywhere.
    private const double MuchMoreAlike = 0.75;
    private const double MinDifference = 1;

    private static readonly int[] Multiples = [1, 2, 16, 32, 64, 128, 256];

    private readonly bool _isThermal = options.Format == ProcessCameraFormat.Grey16;
    private int _looks;
    private int _likely;

    /// <summary>Looks at a picture.</summary>
    /// <param name="bytes">With what is behind its rows.</param>
    /// <param name="start">Where it begins.</param>
    /// <returns>A line for people, once, where all that were looked at say the same; else null.</returns>
    public string? Look(byte[] bytes, int start)
    {
        if (_looks == Pictures)
            return null;
        int likely = FindLikely(bytes, start);
        if (likely < 0)
            return null;
        bool isSame = likely > 0 && (_looks == 0 || likely == _likely);
        _looks = isSame ? _looks + 1 : Pictures;
        _likely = likely;
        return isSame && _looks == Pictures
            ? FormattableString.Invariant(
                $"{options.Program}: rows of its raw pictures look as if they had {likely} bytes, not {RowBytes}: see rowBytes and the camera's size")
            : null;
    }

    private int SampleBytes => _isThermal ? DetectorInput.BytesPerPixel(PixelFormat.Grey16) : 1;

    private int RowBytes => options.RowBytes ?? options.Width * SampleBytes;

    // 0 where it is the one that was given, or none is clearly better; below 0 where the picture does not say it.
    private int FindLikely(byte[] bytes, int start)
    {
        double given = DifferenceAt(bytes, start, RowBytes);
        if (given < MinDifference)
            return -1;
        (int best, double least) = (0, given * MuchMoreAlike);
        foreach (int multiple in Multiples)
        {
            int length = (((options.Width * SampleBytes) + multiple - 1) / multiple) * multiple;
            if (length == RowBytes || length % SampleBytes != 0)
                continue;
            double difference = DifferenceAt(bytes, start, length);
            if (difference < least)
                (best, least) = (length, difference);
        }

        return best;
    }

    private double DifferenceAt(byte[] bytes, int start, int distance)
    {
        int end = start + (RowBytes * options.Height) - Math.Max(distance, RowBytes);
        (long sum, int count) = (0, 0);
        for (int at = start; at + SampleBytes <= end; at += Step * SampleBytes, count++)
            sum += Math.Abs(SampleAt(bytes, at) - SampleAt(bytes, at + distance));
        return count == 0 ? 0 : (double)sum / count;
    }

    private int SampleAt(byte[] bytes, int at) => _isThermal ? bytes[at] | (bytes[at + 1] << 8) : bytes[at];
}
