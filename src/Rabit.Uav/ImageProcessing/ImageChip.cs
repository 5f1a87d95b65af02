using System;

namespace Rabit.Uav.ImageProcessing;

/// <summary>The part of a picture around a reported target, for people. Immutable; any thread.</summary>
public sealed class ImageChip
{
    private readonly byte[] _pixels;

    internal ImageChip(long pictureNumber, int reportIndex, int width, int height, byte[] pixels)
    {
        PictureNumber = pictureNumber;
        ReportIndex = reportIndex;
        Width = width;
        Height = height;
        _pixels = pixels;
    }

    /// <summary>The picture: <see cref="Messages.TargetReport.PictureNumber"/>.</summary>
    public long PictureNumber { get; }

    /// <summary>The report of that picture: <see cref="Messages.TargetReport.Index"/>.</summary>
    public int ReportIndex { get; }

    /// <summary>Columns.</summary>
    public int Width { get; }

    /// <summary>Rows.</summary>
    public int Height { get; }

    /// <summary>
    /// The pixels, a new array at each call: 8 bits each of red, green and blue, row by row from the top left, without
    /// padding.
    /// </summary>
    public byte[] CopyPixels() => (byte[])_pixels.Clone();
}
