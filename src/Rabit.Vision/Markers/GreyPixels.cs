using System;

namespace Rabit.Vision;

/// <summary>Makes colour pictures grey. Any thread.</summary>
public static class GreyPixels
{
    /// <summary>Writes the luma (ITU-R BT.601, as in JPEG) of each pixel.</summary>
    /// <param name="rgb">Red, green, blue, pixel by pixel.</param>
    /// <param name="grey">Takes one byte a pixel; at least a third as long.</param>
    /// <exception cref="ArgumentException">The room for the grey pixels is too small.</exception>
    /// <example>
    /// <code>
    /// byte[] grey = new byte[picture.Width * picture.Height];
    /// GreyPixels.FromRgb(picture.Pixels, grey);
    /// </code>
    /// </example>
    public static unsafe void FromRgb(ReadOnlySpan<byte> rgb, Span<byte> grey)
    {
        int count = rgb.Length / 3;
        if (grey.Length < count)
            throw new ArgumentException(
                $"A buffer of {grey.Length} bytes does not hold {count} grey pixels.", nameof(grey));
        fixed (byte* from = rgb)
        fixed (byte* to = grey)
        {
            byte* p = from;
            for (int i = 0; i < count; i++, p += 3)
                to[i] = (byte)(((p[0] * 77) + (p[1] * 150) + (p[2] * 29) + 128) >> 8);
        }
    }
}
