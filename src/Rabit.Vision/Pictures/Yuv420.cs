using System;

namespace Rabit.Vision;

/// <summary>
/// Raw pictures of camera programs: all brightness, then all of the first colour, then all of the second, each with
/// half of the columns and rows (I420, "yuv420p"; ITU-R BT.601). Any thread.
/// </summary>
/// <example>
/// <code>
/// byte[] raw = new byte[Yuv420.BytesOf(640, 480)];
/// Yuv420.ToRgb(raw, 0, 640, 480, isFullRange: false, pixels);
/// </code>
/// </example>
public static class Yuv420
{
    private const int Half = 1 << 15;

    /// <summary>Bytes of a picture.</summary>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    public static int BytesOf(int width, int height)
        => (width * height) + (2 * ((width + 1) / 2) * ((height + 1) / 2));

    /// <summary>Makes red, green and blue of it.</summary>
    /// <param name="raw">The bytes.</param>
    /// <param name="offset">Where the picture begins in them.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="isFullRange">
    /// Whether black is 0 and white 255, as in a JPEG; else they are 16 and 235, as in video.
    /// </param>
    /// <param name="pixels">Takes red, green and blue, row by row.</param>
    public static void ToRgb(byte[] raw, int offset, int width, int height, bool isFullRange, byte[] pixels)
    {
        PixelBuffer.Check(pixels, width, height);
        if (raw is null)
            throw new ArgumentNullException(nameof(raw));
        if (offset < 0 || offset > raw.Length - BytesOf(width, height))
            throw new ArgumentOutOfRangeException(nameof(offset), "The picture is not in the array.");
        int across = (width + 1) / 2;
        int blues = offset + (width * height);
        int reds = blues + (across * ((height + 1) / 2));
        int scale = isFullRange ? 65_536 : 76_309;              // 255 / 219
        int redOfCr = isFullRange ? 91_881 : 104_597;           // 1.402, and times 255 / 224
        int greenOfCb = isFullRange ? 22_554 : 25_675;
        int greenOfCr = isFullRange ? 46_802 : 53_279;
        int blueOfCb = isFullRange ? 116_130 : 132_201;
        int black = isFullRange ? 0 : 16;
        int to = 0;
        for (int row = 0; row < height; row++)
        {
            int light = offset + (row * width);
            int colour = row / 2 * across;
            for (int column = 0; column < width; column++, to += 3)
            {
                int brightness = ((raw[light + column] - black) * scale) + Half;
                int blue = raw[blues + colour + (column / 2)] - 128;
                int red = raw[reds + colour + (column / 2)] - 128;
                pixels[to] = Clamp((brightness + (redOfCr * red)) >> 16);
                pixels[to + 1] = Clamp((brightness - (greenOfCb * blue) - (greenOfCr * red)) >> 16);
                pixels[to + 2] = Clamp((brightness + (blueOfCb * blue)) >> 16);
            }
        }
    }

    private static byte Clamp(int value) => value < 0 ? (byte)0 : value > 255 ? (byte)255 : (byte)value;
}
