using Rabit.Uav.Messages;

namespace Rabit.Uav.ImageProcessing;

/// <summary>What the program of a <see cref="ProcessCamera"/> writes.</summary>
public enum ProcessCameraFormat
{
    /// <summary>
    /// JPEG pictures, one after the other: <c>rpicam-vid --codec mjpeg</c>, <c>ffmpeg -f mjpeg</c>.
    /// </summary>
    Mjpeg,

    /// <summary>
    /// Raw pictures with black at 16 and white at 235: <c>rpicam-vid --codec yuv420</c>, <c>ffmpeg -f rawvideo
    /// -pix_fmt yuv420p</c>. The former pads its rows: <see cref="ProcessCameraOptions.RowBytes"/>.
    /// </summary>
    Yuv420,

    /// <summary>The same with black at 0 and white at 255: <c>ffmpeg -pix_fmt yuvj420p</c>.</summary>
    Yuv420FullRange,

    /// <summary>
    /// Raw pictures of a thermal camera, counts of 16 bits, the lower byte first: <c>ffmpeg -f rawvideo -pix_fmt
    /// gray16le</c>. They are pictures of <see cref="PixelFormat.Grey16"/>.
    /// </summary>
    Grey16,
}
