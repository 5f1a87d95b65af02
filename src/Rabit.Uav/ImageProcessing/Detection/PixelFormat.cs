namespace Rabit.Uav.ImageProcessing;

/// <summary>How the bytes of a picture are arranged.</summary>
public enum PixelFormat
{
    /// <summary>
    /// Three bytes for each pixel: red, green and blue, 0 to 255; rows from the top, pixels from the left.
    /// </summary>
    Rgb24,
}
