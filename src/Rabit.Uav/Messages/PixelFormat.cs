namespace Rabit.Uav.Messages;

/// <summary>How the bytes of a picture are arranged.</summary>
public enum PixelFormat
{
    /// <summary>
    /// Three bytes for each pixel: red, green and blue, 0 to 255; rows from the top, pixels from the left.
    /// </summary>
    Rgb24,

    /// <summary>
    /// Two bytes for each pixel, the lower one first: counts of a thermal camera, 0 to 65535, more where it is warmer;
    /// rows from the top, pixels from the left.
    /// </summary>
    Grey16,
}
