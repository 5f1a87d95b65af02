using System.Collections.Generic;

namespace Rabit.Uav.ImageProcessing;

/// <summary>A whole picture with reports, scaled down, for people. Immutable; any thread.</summary>
public sealed class PictureOverview
{
    private readonly byte[] _pixels;

    internal PictureOverview(long pictureNumber, int width, int height, byte[] pixels, IReadOnlyList<PictureBox> boxes)
        => (PictureNumber, Width, Height, _pixels, Boxes) = (pictureNumber, width, height, pixels, boxes);

    /// <summary>The picture: <see cref="Messages.TargetReport.PictureNumber"/>.</summary>
    public long PictureNumber { get; }

    /// <summary>Columns.</summary>
    public int Width { get; }

    /// <summary>Rows.</summary>
    public int Height { get; }

    /// <summary>Where its reports are.</summary>
    public IReadOnlyList<PictureBox> Boxes { get; }

    /// <summary>
    /// The pixels, a new array at each call: 8 bits each of red, green and blue, row by row from the top left, without
    /// padding.
    /// </summary>
    public byte[] CopyPixels() => (byte[])_pixels.Clone();
}
