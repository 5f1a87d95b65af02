using System;
using System.Collections.Generic;

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
    public void Add(
        long pictureNumber, int reportIndex, byte[] picture, int width, int height, double centreX, double centreY)
    {
        if (capacity == 0)
            return;
        int left = Math.Max(0, (int)Math.Round(centreX) - (side / 2));
        int top = Math.Max(0, (int)Math.Round(centreY) - (side / 2));
        int columns = Math.Min(side, width - left);
        int rows = Math.Min(side, height - top);
        var pixels = new byte[columns * rows * 3];
        for (int row = 0; row < rows; row++)
            Buffer.BlockCopy(picture, (((top + row) * width) + left) * 3, pixels, row * columns * 3, columns * 3);
        var chip = new ImageChip(pictureNumber, reportIndex, columns, rows, pixels);
        lock (_gate)
        {
            if (_kept.Count == capacity)
                _kept.Dequeue();
            _kept.Enqueue(chip);
        }
    }
}
