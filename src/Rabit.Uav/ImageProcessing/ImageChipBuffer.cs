using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// The newest image chips, a bounded number. Image Processing adds; any thread reads. It is no channel between
/// managers: it is for displays of the flight.
/// </summary>
internal sealed class ImageChipBuffer(int capacity, int side)
{
    private readonly object _gate = new();
    private readonly Queue<ImageChip> _kept = new(capacity);   // under _gate

    public IReadOnlyList<ImageChip> Kept
    {
        get
        {
            lock (_gate)
                return _kept.ToArray();
        }
    }

    /// <summary>Cuts a square out around a place; less where the border is near.</summary>
    public void Add(long pictureNumber, int reportIndex, in CameraFrame frame, double centreX, double centreY)
    {
        (byte[] picture, int width, int height) = (frame.Pixels.Array, frame.Width, frame.Height);
        if (capacity == 0)
            return;
        int left = Math.Max(0, (int)Math.Round(centreX) - (side / 2));
        int top = Math.Max(0, (int)Math.Round(centreY) - (side / 2));
        int columns = Math.Min(side, width - left);
        int rows = Math.Min(side, height - top);
        var pixels = new byte[columns * rows * 3];
        if (frame.Format == PixelFormat.Grey16)
            CopyCounts(MemoryMarshal.Cast<byte, ushort>(picture), (top * width) + left, width, pixels, columns);
        for (int row = 0; frame.Format == PixelFormat.Rgb24 && row < rows; row++)
            Buffer.BlockCopy(picture, (((top + row) * width) + left) * 3, pixels, row * columns * 3, columns * 3);
        var chip = new ImageChip(pictureNumber, reportIndex, columns, rows, pixels);
        lock (_gate)
        {
            if (_kept.Count == capacity)
                _kept.Dequeue();
            _kept.Enqueue(chip);
        }
    }

    // Grey, from the coldest to the warmest of the chip.
    private static void CopyCounts(ReadOnlySpan<ushort> counts, int first, int width, byte[] pixels, int columns)
    {
        (int least, int most) = (ushort.MaxValue, 0);
        for (int i = 0; i < pixels.Length / 3; i++)
        {
            int count = counts[first + (i / columns * width) + (i % columns)];
            (least, most) = (Math.Min(least, count), Math.Max(most, count));
        }

        for (int i = 0; i < pixels.Length / 3; i++)
        {
            int count = counts[first + (i / columns * width) + (i % columns)];
            byte level = (byte)((count - least) * 255 / Math.Max(1, most - least));
            (pixels[3 * i], pixels[(3 * i) + 1], pixels[(3 * i) + 2]) = (level, level, level);
        }
    }
}
