using System;
using System.Collections.Immutable;
using System.Runtime.InteropServices;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// The newest pictures with reports, scaled down, a bounded number. Image Processing adds, and allocates nothing once
/// all places are in use; any thread asks for one. As <see cref="ImageChipBuffer"/> it is for displays.
/// </summary>
internal sealed class PictureOverviewBuffer(int capacity, int maxWidth)
{
    private readonly object _gate = new();
    private readonly Kept?[] _ring = new Kept?[capacity];   // under _gate
    private long _count;                                    // under _gate

    /// <summary>Keeps a picture, if there are reports in it.</summary>
    public void Add(
        in CameraObservation observation, byte[] picture, int width, int height,
        PixelFormat format = PixelFormat.Rgb24)
    {
        if (capacity == 0 || observation.Reports.IsEmpty)
            return;
        int scale = ((width - 1) / maxWidth) + 1;
        lock (_gate)
        {
            ref Kept? kept = ref _ring[_count++ % capacity];
            if (kept?.Fits(width / scale, height / scale) != true)
                kept = new Kept(width / scale, height / scale);
            kept.Set(observation, width, height);
            if (format == PixelFormat.Grey16)
                kept.SetCounts(MemoryMarshal.Cast<byte, ushort>(picture), width, scale);
            else
                kept.SetColours(picture, width, scale);
        }
    }

    /// <summary>The picture of a number; null where it is no longer, or never was, kept.</summary>
    public PictureOverview? Find(long number)
    {
        lock (_gate)
        {
            for (long i = _count - 1; i >= 0 && i >= _count - capacity; i--)
            {
                if (_ring[i % capacity] is { } kept && kept.Number == number)
                    return kept.Copy();
            }
        }

        return null;
    }

    private sealed class Kept(int width, int height)
    {
        private readonly byte[] _pixels = new byte[width * height * 3];
        private readonly int[] _sums = new int[width * 3]; // of one row
        private ImmutableArray<TargetReport> _reports = [];
        private int _pictureWidth;
        private int _pictureHeight;

        public long Number { get; private set; }

        public bool Fits(int columns, int rows) => columns == width && rows == height;

        public void Set(in CameraObservation observation, int pictureWidth, int pictureHeight)
        {
            (Number, _reports) = (observation.Number, observation.Reports);
            (_pictureWidth, _pictureHeight) = (pictureWidth, pictureHeight);
        }

        public void SetColours(byte[] picture, int pictureWidth, int scale)
        {
            int to = 0;
            for (int row = 0; row < height; row++)
            {
                Array.Clear(_sums, 0, _sums.Length);
                for (int line = row * scale; line < (row + 1) * scale; line++)
                    AddLine(picture.AsSpan(line * pictureWidth * 3, _sums.Length * scale), scale);
                foreach (int sum in _sums)
                    _pixels[to++] = (byte)(sum / (scale * scale));
            }
        }

        // Grey, from the coldest to the warmest.
        public void SetCounts(ReadOnlySpan<ushort> counts, int pictureWidth, int scale)
        {
            (int least, int most) = (ushort.MaxValue, 0);
            for (int i = 0; i < width * height; i++)
            {
                int mean = MeanOf(counts, FirstOf(i, pictureWidth, scale), pictureWidth, scale);
                (least, most) = (Math.Min(least, mean), Math.Max(most, mean));
            }

            for (int i = 0; i < width * height; i++)
            {
                int mean = MeanOf(counts, FirstOf(i, pictureWidth, scale), pictureWidth, scale);
                byte level = (byte)((mean - least) * 255 / Math.Max(1, most - least));
                (_pixels[3 * i], _pixels[(3 * i) + 1], _pixels[(3 * i) + 2]) = (level, level, level);
            }
        }

        public PictureOverview Copy()
        {
            var boxes = new PictureBox[_reports.Length];
            for (int i = 0; i < boxes.Length; i++)
                boxes[i] = BoxOf(_reports[i]);
            return new PictureOverview(Number, width, height, (byte[])_pixels.Clone(), boxes);
        }

        private void AddLine(ReadOnlySpan<byte> line, int scale)
        {
            int from = 0;
            for (int to = 0; to < _sums.Length; to += 3)
            {
                (int red, int green, int blue) = (0, 0, 0);
                for (int i = 0; i < scale; i++, from += 3)
                {
                    red += line[from];
                    green += line[from + 1];
                    blue += line[from + 2];
                }

                _sums[to] += red;
                _sums[to + 1] += green;
                _sums[to + 2] += blue;
            }
        }

        private int FirstOf(int index, int pictureWidth, int scale)
            => (index / width * scale * pictureWidth) + (index % width * scale);

        private static int MeanOf(ReadOnlySpan<ushort> counts, int first, int stride, int scale)
        {
            long sum = 0;
            for (int row = 0; row < scale; row++)
            {
                foreach (ushort count in counts.Slice(first + (row * stride), scale))
                    sum += count;
            }

            return (int)(sum / (scale * scale));
        }

        // The centre of the first pixel is 0, its border half a pixel before it.
        private PictureBox BoxOf(in TargetReport report) => new(
            report.Index, (report.CentreX + 0.5 - (report.WidthPixels / 2)) / _pictureWidth,
            (report.CentreY + 0.5 - (report.HeightPixels / 2)) / _pictureHeight, report.WidthPixels / _pictureWidth,
            report.HeightPixels / _pictureHeight);
    }
}
