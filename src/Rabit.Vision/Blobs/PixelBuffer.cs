using System;

namespace Rabit.Vision;

/// <summary>Checks of a buffer of pixels.</summary>
internal static class PixelBuffer
{
    public static void Check(byte[] pixels, int width, int height)
    {
        if (pixels is null)
            throw new ArgumentNullException(nameof(pixels));
        if (width < 1 || height < 1 || pixels.Length / 3 / width < height)
            throw new ArgumentException(
                $"A buffer of {pixels.Length} bytes does not hold a picture of {width} x {height} pixels.",
                nameof(pixels));
    }
}
