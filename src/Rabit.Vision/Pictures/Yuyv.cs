using System;

namespace Rabit.Vision;

/// <summary>
/// Raw pictures of USB cameras: two pixels are four bytes, brightness, blue, brightness, red ("YUYV", "YUY2"; ITU-R
/// BT.601). Any thread.
/// </summary>
/// <example>
/// <code>
/// byte[] raw = new byte[640 * 480 * 2];
/// Yuyv.ToRgb(raw, 0, 640 * 2, 640, 480, isFullRange: false, pixels);
/// </code>
/// </example>
public static class Yuyv
{
    private const int Half = 1 << 15;

    /// <summary>Makes red, green and blue of it.</summary>
    /// <param name="raw">The bytes.</param>
    /// <param name="offset">Where the picture begins in them.</param>
    /// <param name="rowBytes">From one row to the next, at least two for each column.</param>
    /// <param name="width">Columns, an even number.</param>
    /// <param name="height">Rows.</param>
    /// <param name="isFullRange">Whether black is 0 and white 255; else they are 16 and 235, as in video.</param>
    /// <param name="pixels">Takes red, green and blue, row by row.</param>
    public static void ToRgb(
        byte[] raw, int offset, int rowBytes, int width, int height, bool isFullRange, byte[] pixels)
    {
        PixelBuffer.Check(pixels, width, height);
        if (raw is null)
            throw new ArgumentNullException(nameof(raw));
        if (width % 2 != 0)
            throw new ArgumentOutOfRangeException(nameof(width), "The columns are in pairs.");
        if (rowBytes < 2 * width)
            throw new ArgumentOutOfRangeException(nameof(rowBytes), "A row has two bytes for each column.");
        if (offset < 0 || offset > raw.Length - ((rowBytes * (long)(height - 1)) + (2 * width)))
            throw new ArgumentOutOfRangeException(nameof(offset), "The picture is not in the array.");
        for (int row = 0; row < height; row++)
        {
            ConvertRow(
                raw.AsSpan(offset + (row * rowBytes), 2 * width), isFullRange,
                pixels.AsSpan(row * width * 3, width * 3));
        }
    }

    private static void ConvertRow(ReadOnlySpan<byte> raw, bool isFullRange, Span<byte> pixels)
    {
        int scale = isFullRange ? 65_536 : 76_309;              // 255 / 219
        int redOfCr = isFullRange ? 91_881 : 104_597;           // 1.402, and times 255 / 224
        int greenOfCb = isFullRange ? 22_554 : 25_675;
        int greenOfCr = isFullRange ? 46_802 : 53_279;
        int blueOfCb = isFullRange ? 116_130 : 132_201;
        int black = isFullRange ? 0 : 16;
        int to = 0;
        for (int at = 0; at + 3 < raw.Length; at += 4, to += 6)
        {
            int blue = raw[at + 1] - 128;
            int red = raw[at + 3] - 128;
            (int r, int g, int b) = (redOfCr * red, (greenOfCb * blue) + (greenOfCr * red), blueOfCb * blue);
            int first = ((raw[at] - black) * scale) + Half;
            int second = ((raw[at + 2] - black) * scale) + Half;
            pixels[to] = Clamp((first + r) >> 16);
            pixels[to + 1] = Clamp((first - g) >> 16);
            pixels[to + 2] = Clamp((first + b) >> 16);
            pixels[to + 3] = Clamp((second + r) >> 16);
            pixels[to + 4] = Clamp((second - g) >> 16);
            pixels[to + 5] = Clamp((second + b) >> 16);
        }
    }

    private static byte Clamp(int value) => value < 0 ? (byte)0 : value > 255 ? (byte)255 : (byte)value;
}
