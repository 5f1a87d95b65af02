using Rabit.Vision;

namespace Rabit.Uav.ImageProcessing;

/// <summary>Decodes the pictures of one camera, which are all of one size. One thread.</summary>
internal sealed class CameraPictures(string camera, int width, int height)
{
    private readonly JpegDecoder _jpeg = new();

    /// <summary>For the log: what decodes JPEG pictures.</summary>
    public string EngineText => "JPEG pictures are decoded by " + _jpeg.Engine;

    /// <summary>Decodes a JPEG.</summary>
    /// <exception cref="PictureException">It is none, or has another size.</exception>
    public void DecodeJpeg(byte[] bytes, int start, int length, byte[] pixels)
    {
        _jpeg.Open(bytes, start, length, camera);
        if (_jpeg.Width != width || _jpeg.Height != height)
            throw new PictureException(
                camera, $"a picture is {_jpeg.Width} x {_jpeg.Height}; {width} x {height} are wanted");
        _jpeg.Decode(pixels);
    }

    /// <summary>Converts raw YUV 4:2:0.</summary>
    public void ConvertYuv420(byte[] bytes, int start, bool isFullRange, byte[] pixels)
        => Yuv420.ToRgb(bytes, start, width, height, isFullRange, pixels);
}
