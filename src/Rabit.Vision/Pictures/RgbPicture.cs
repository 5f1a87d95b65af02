using System;

namespace Rabit.Vision;

/// <summary>A picture with 8 bits each of red, green and blue, row by row from the top left, without padding.</summary>
/// <example>
/// <code>
/// var picture = new RgbPicture(640, 480, new byte[640 * 480 * 3]);
/// picture.Pixels[((row * picture.Width) + column) * 3] = 255;   // the red of a pixel
/// </code>
/// </example>
public sealed class RgbPicture
{
    /// <summary>Maximum of columns, and of rows.</summary>
    public const int MaxPixelsPerSide = 16_384;

    /// <summary>Maximum of pixels: 50 million, more than the cameras that small aircraft carry.</summary>
    public const int MaxPixels = 50_000_000;

    /// <summary>Makes a picture of bytes, which are not copied.</summary>
    /// <param name="width">Columns, 1 to <see cref="MaxPixelsPerSide"/>.</param>
    /// <param name="height">Rows, 1 to <see cref="MaxPixelsPerSide"/>.</param>
    /// <param name="pixels">
    /// At least width x height x 3 bytes; what follows them does not belong to the picture.
    /// </param>
    /// <exception cref="ArgumentException">The size is out of range, or the bytes are too few.</exception>
    public RgbPicture(int width, int height, byte[] pixels)
    {
        if (FindSizeFault(width, height) is { } fault)
            throw new ArgumentException("A picture: " + fault + ".", nameof(width));
        Pixels = pixels ?? throw new ArgumentNullException(nameof(pixels));
        if (pixels.Length < width * height * 3)
            throw new ArgumentException(
                $"A picture of {width} x {height} needs {width * height * 3} bytes; there are {pixels.Length}.",
                nameof(pixels));
        (Width, Height) = (width, height);
    }

    /// <summary>Columns.</summary>
    public int Width { get; }

    /// <summary>Rows.</summary>
    public int Height { get; }

    /// <summary>The bytes: red, green and blue of each pixel.</summary>
    public byte[] Pixels { get; }

    /// <summary>What is wrong with the size of a picture; null if nothing is.</summary>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    public static string? FindSizeFault(long width, long height)
    {
        if (width < 1 || height < 1)
            return $"its size of {width} x {height} is none";
        return width > MaxPixelsPerSide || height > MaxPixelsPerSide || width * height > MaxPixels
            ? $"its size of {width} x {height} is more than this reads (at most {MaxPixelsPerSide} a side and "
                + $"{MaxPixels} pixels)"
            : null;
    }
}
