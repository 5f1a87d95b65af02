using System;

namespace Rabit.Vision;

/// <summary>
/// Single pictures as JPEG, as <see cref="JpegDecoder"/> reads them; that is for many, one after the other. Any thread.
/// </summary>
/// <example>
/// <code>
/// RgbPicture picture = JpegPicture.Decode(File.ReadAllBytes("frame.jpg"), "frame.jpg");
/// </code>
/// </example>
public static class JpegPicture
{
    /// <summary>Reads a picture out of the bytes of a JPEG file.</summary>
    /// <param name="file">The bytes.</param>
    /// <param name="name">What errors call it.</param>
    /// <exception cref="PictureException">The bytes are no JPEG, of a kind that is not read, or damaged.</exception>
    public static RgbPicture Decode(byte[] file, string name)
    {
        if (file is null)
            throw new ArgumentNullException(nameof(file));
        var decoder = new JpegDecoder();
        decoder.Open(file, 0, file.Length, name);
        byte[] pixels = new byte[decoder.Width * decoder.Height * 3];
        decoder.Decode(pixels);
        return new RgbPicture(decoder.Width, decoder.Height, pixels);
    }
}
