using System;

namespace Rabit.Vision;

/// <summary>
/// Finds warm spots in thermal pictures of 16 bits: pixels that are warmer than the ground around them by counts and by
/// noise, joined down to half of the contrast of the warmest. Pixels that alone are bright, as defects of a sensor are,
/// are none. Memory that is used again: nothing is allocated for further pictures of a size. One thread.
/// </summary>
/// <example>
/// <code>
/// var counts = new ushort[640 * 512];
/// new PictureReader().LoadCountsInto("a.pgm", 640, 512, counts);
/// var finder = new HotSpotFinder();
/// var limits = new HotSpotLimits { MinContrast = 40, MinSigmas = 6, MaxSide = 20 };
/// foreach (HotSpot spot in finder.Find(counts, 640, 512, limits))
///     Console.WriteLine($"{spot.Contrast} counts at {spot.CentreX}, {spot.CentreY}");
/// </code>
/// </example>
public sealed class HotSpotFinder
{
    /// <summary>How many spots of a picture are kept, the warmest.</summary>
    public const int MaxSpots = 512;

    // Even a point is spread by the lens over more than a pixel: one whose neighbours have less of its contrast is a
    // defect.
    private const float MinNeighbourShare = 0.15f;

    // A spot goes on where there is so much of the contrast of its warmest pixel.
    private const float EdgeShare = 0.4f;

    // Its warmest part, by which its area is measured: the mean of the pixels with so much of the largest contrast.
    private const float PlateauShare = 0.8f;

    // The ground around it, pixels beyond its box: a part of something larger goes on there.
    private const int RingFrom = 2;
    private const int RingTo = 4;
    private const double MaxWarmRing = 0.15;
    private const int MaxRing = 4096;

    private readonly ushort[] _ring = new ushort[MaxRing];
    private readonly ThermalBackground _background = new();
    private readonly HotSpot[] _spots = new HotSpot[MaxSpots];
    private float[] _contrast = [];
    private bool[] _isTaken = [];
    private int[] _queue = [];
    private int[] _peaks = new int[256];
    private float[] _peakContrasts = new float[256];
    private int _width;
    private int _height;
    private ushort _saturated;

    /// <summary>Spots of the last picture that had no room.</summary>
    public int Dropped { get; private set; }

    /// <summary>Pixels of the last picture that are bright alone, and were taken for defects of the sensor.</summary>
    public int DefectPixels { get; private set; }

    /// <summary>The noise of a pixel of the last picture, one standard deviation, counts.</summary>
    public double Noise => _background.Noise;

    /// <summary>Finds the spots.</summary>
    /// <param name="pixels">Counts, more where it is warmer, row by row from the top left.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="limits">What is a spot.</param>
    /// <returns>The warmest first; valid until the next picture.</returns>
    /// <exception cref="ArgumentException">The size is not positive, or the pixels are too few for it.</exception>
    public ReadOnlySpan<HotSpot> Find(ReadOnlySpan<ushort> pixels, int width, int height, HotSpotLimits limits)
    {
        if (width < 1 || height < 1 || pixels.Length / width < height)
            throw new ArgumentException(
                $"{pixels.Length} pixels are no picture of {width} x {height}.", nameof(pixels));
        (_width, _height, Dropped, DefectPixels) = (width, height, 0, 0);
        if (_contrast.Length < width * height)
            (_contrast, _isTaken, _queue) =
                (new float[width * height], new bool[width * height], new int[width * height]);
        Array.Clear(_isTaken, 0, width * height);
        _background.Set(pixels, width, height, limits.MaxSide);
        _saturated = SetContrast(pixels);
        float threshold = (float)Math.Max(limits.MinContrast, limits.MinSigmas * _background.Noise);
        RemoveDefects(threshold);
        int peaks = FindPeaks(threshold);
        int count = 0;
        for (int i = 0; i < peaks; i++)
        {
            if (_isTaken[_peaks[i]])
                continue;
            HotSpot spot = Measure(Fill(_peaks[i]), _contrast[_peaks[i]], pixels, threshold);
            if (!IsAlone(spot, pixels, threshold, limits.MaxSide))
                continue;
            if (count == MaxSpots)
                Dropped++;
            else
                _spots[count++] = spot;
        }

        return new ReadOnlySpan<HotSpot>(_spots, 0, count);
    }

    // The warmest first: what is around it belongs to it.
    private int FindPeaks(float threshold)
    {
        int count = 0;
        for (int at = 0; at < _width * _height; at++)
        {
            if (_contrast[at] < threshold || _contrast[at] < WarmestNeighbour(at))
                continue;
            if (count == _peaks.Length)
            {
                Array.Resize(ref _peaks, 2 * count);
                Array.Resize(ref _peakContrasts, 2 * count);
            }

            _peaks[count] = at;
            _peakContrasts[count++] = _contrast[at];
        }

        InPlaceOrder.SortDescending(_peakContrasts, _peaks, count);
        return count;
    }

    // Of 14 bits or 16: the largest value is the end of the range where several pixels have it.
    private ushort SetContrast(ReadOnlySpan<ushort> pixels)
    {
        ushort largest = 0;
        for (int row = 0; row < _height; row++)
        {
            ReadOnlySpan<float> ground = _background.Row(row, _width, _height);
            int at = row * _width;
            for (int column = 0; column < _width; column++, at++)
            {
                _contrast[at] = pixels[at] - ground[column];
                largest = Math.Max(largest, pixels[at]);
            }
        }

        return largest is 4095 or 16383 or ushort.MaxValue ? largest : (ushort)0;
    }

    private void RemoveDefects(float threshold)
    {
        for (int at = 0; at < _width * _height; at++)
        {
            if (_contrast[at] < threshold)
                continue;
            float warmest = WarmestNeighbour(at);
            if (warmest < MinNeighbourShare * _contrast[at])
            {
                DefectPixels++;
                _contrast[at] = Math.Max(0, warmest);
            }
        }
    }

    private float WarmestNeighbour(int at)
    {
        int column = at % _width;
        float warmest = float.MinValue;
        if (column > 0)
            warmest = Math.Max(warmest, _contrast[at - 1]);
        if (column < _width - 1)
            warmest = Math.Max(warmest, _contrast[at + 1]);
        if (at >= _width)
            warmest = Math.Max(warmest, _contrast[at - _width]);
        if (at < _width * (_height - 1))
            warmest = Math.Max(warmest, _contrast[at + _width]);
        return warmest;
    }

    // Four neighbours; at least twice the noise.
    private int Fill(int peak)
    {
        float least = (float)Math.Max(EdgeShare * _contrast[peak], 2 * _background.Noise);
        _queue[0] = peak;
        _isTaken[peak] = true;
        return Fill(1, least, float.PositiveInfinity);
    }

    // Goes on from what is in the queue: to pixels with so much contrast, and by so much more than where they are
    // reached from.
    private int Fill(int length, float least, float mostRise)
    {
        for (int i = 0; i < length; i++)
        {
            int at = _queue[i];
            int column = at % _width;
            float most = _contrast[at] + mostRise;
            if (column > 0)
                Take(at - 1, least, most, ref length);
            if (column < _width - 1)
                Take(at + 1, least, most, ref length);
            if (at >= _width)
                Take(at - _width, least, most, ref length);
            if (at < _width * (_height - 1))
                Take(at + _width, least, most, ref length);
        }

        return length;
    }

    private void Take(int at, float least, float most, ref int length)
    {
        if (_isTaken[at] || _contrast[at] < least || _contrast[at] > most)
            return;
        _isTaken[at] = true;
        _queue[length++] = at;
    }

    private HotSpot Measure(int length, float warmest, ReadOnlySpan<ushort> pixels, float threshold)
    {
        var spot = new HotSpot
        {
            Left = int.MaxValue,
            Top = int.MaxValue,
            Right = -1,
            Bottom = -1,
            Noise = _background.Noise,
        };
        (double sum, double x, double y, double plateau, int onPlateau) = (0, 0, 0, 0, 0);
        for (int i = 0; i < length; i++)
        {
            (int column, int row) = (_queue[i] % _width, _queue[i] / _width);
            double contrast = _contrast[_queue[i]];
            (sum, x, y) = (sum + contrast, x + (contrast * column), y + (contrast * row));
            (spot.Left, spot.Right) = (Math.Min(spot.Left, column), Math.Max(spot.Right, column));
            (spot.Top, spot.Bottom) = (Math.Min(spot.Top, row), Math.Max(spot.Bottom, row));
            if (contrast >= PlateauShare * warmest)
                (plateau, onPlateau) = (plateau + contrast, onPlateau + 1);
            if (_saturated > 0 && pixels[_queue[i]] >= _saturated)
                spot.SaturatedPixels++;
        }

        (spot.CentreX, spot.CentreY) = (x / sum, y / sum);
        spot.Contrast = plateau / onPlateau;
        spot.Area = sum / spot.Contrast;
        (double xx, double xy, double yy, double nxx, double nxy, double nyy) = (0, 0, 0, 0, 0, 0);
        for (int i = 0; i < length; i++)
        {
            double dx = (_queue[i] % _width) - spot.CentreX;
            double dy = (_queue[i] / _width) - spot.CentreY;
            double contrast = _contrast[_queue[i]];
            (xx, xy, yy) = (xx + (contrast * dx * dx), xy + (contrast * dx * dy), yy + (contrast * dy * dy));
            (nxx, nxy, nyy) = (nxx + (dx * dx), nxy + (dx * dy), nyy + (dy * dy));
        }

        (spot.MomentXX, spot.MomentXY, spot.MomentYY) = (xx / sum, xy / sum, yy / sum);

        // The centroid is the sum of contrast times distance by the sum of contrast: so the noise of each pixel adds.
        double byNoise = spot.Noise * spot.Noise / (sum * sum);
        (spot.VarianceX, spot.CovarianceXY, spot.VarianceY) = (byNoise * nxx, byNoise * nxy, byNoise * nyy);

        // The fading edge of a very warm one is no spot of its own; one beside it, which is warmer again, is.
        Fill(length, threshold, (float)(2 * spot.Noise));
        return spot;
    }

    // Against the counts around its box, whatever the background of the picture is.
    private bool IsAlone(in HotSpot spot, ReadOnlySpan<ushort> pixels, float threshold, double maxSide)
    {
        int longest = Math.Max(spot.Right - spot.Left, spot.Bottom - spot.Top);
        if (longest > (2 * maxSide) + RingTo)
            return false;
        int count = 0;
        int bottom = Math.Min(_height - 1, spot.Bottom + RingTo);
        int right = Math.Min(_width - 1, spot.Right + RingTo);
        for (int row = Math.Max(0, spot.Top - RingTo); row <= bottom; row++)
        {
            for (int column = Math.Max(0, spot.Left - RingTo); column <= right && count < MaxRing; column++)
            {
                bool isInside = row > spot.Top - RingFrom && row < spot.Bottom + RingFrom
                    && column > spot.Left - RingFrom && column < spot.Right + RingFrom;
                if (!isInside)
                    _ring[count++] = pixels[(row * _width) + column];
            }
        }

        if (count == 0)
            return false;
        double warmest = spot.Contrast + _background.At(spot.CentreX, spot.CentreY, _width, _height);
        double contrast = warmest - InPlaceOrder.Nth(_ring, count, count / 2);
        return contrast >= threshold
            && InPlaceOrder.Nth(_ring, count, (int)((1 - MaxWarmRing) * (count - 1))) <= warmest - (contrast / 2);
    }
}
