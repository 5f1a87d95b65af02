using System;
using System.IO;
using System.IO.Compression;

namespace Rabit.Vision;

/// <summary>
/// Pictures as PNG (W3C, "Portable Network Graphics Specification", third edition). Writes 8-bit RGB; reads 8-bit RGB,
/// RGBA (alpha is dropped), grey, grey with alpha, and palette, not interlaced. Any thread.
/// </summary>
/// <example>
/// <code>
/// byte[] file = PngPicture.Encode(new RgbPicture(2, 1, [255, 0, 0, 0, 0, 255]));   // a red and a blue pixel
/// RgbPicture again = PngPicture.Decode(file, "two pixels");
/// </code>
/// </example>
public static class PngPicture
{
    internal const int HeaderLength = 13;
    internal const uint Header = 0x49484452;
    internal const uint Palette = 0x504C5445;
    internal const uint Data = 0x49444154;
    internal const uint End = 0x49454E44;

    private const byte FilterSub = 1;
    private const byte TruecolourRgb = 2;

    // RFC 1950, 2.2: deflate with a window of 32 KiB, the fastest level; a multiple of 31.
    private const byte ZlibMethod = 0x78;
    private const byte ZlibFlags = 0x01;

    internal static readonly byte[] Signature = [0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A];

    /// <summary>Makes the bytes of a PNG file.</summary>
    /// <param name="picture">The picture.</param>
    /// <param name="metadata">
    /// What it says of itself, as EXIF (chunk eXIf) and XMP (chunk iTXt); null for nothing. What is no number, or out
    /// of its range, is left out.
    /// </param>
    public static byte[] Encode(RgbPicture picture, PhotoMetadata? metadata = null)
    {
        if (picture is null)
            throw new ArgumentNullException(nameof(picture));
        using var file = new MemoryStream();
        file.Write(Signature, 0, Signature.Length);
        byte[] header = new byte[HeaderLength];
        PutNumber(header, 0, (uint)picture.Width);
        PutNumber(header, 4, (uint)picture.Height);
        (header[8], header[9]) = (8, TruecolourRgb);
        WriteChunk(file, Header, header, header.Length);
        if (metadata is not null)
        {
            byte[] exif = ExifWriter.Write(metadata);
            WriteChunk(file, PngMetadata.Exif, exif, exif.Length);
            byte[] xmp = PngMetadata.XmpChunk(XmpWriter.Write(metadata));
            WriteChunk(file, PngMetadata.InternationalText, xmp, xmp.Length);
        }

        using MemoryStream data = Compress(picture);
        WriteChunk(file, Data, data.GetBuffer(), (int)data.Length);
        WriteChunk(file, End, [], 0);
        return file.ToArray();
    }

    /// <summary>Reads a picture out of the bytes of a PNG file.</summary>
    /// <param name="file">The bytes.</param>
    /// <param name="name">What errors call it.</param>
    /// <exception cref="PictureException">The bytes are no PNG, one of a kind that is not read, or damaged.</exception>
    public static RgbPicture Decode(byte[] file, string name)
    {
        if (file is null)
            throw new ArgumentNullException(nameof(file));
        var png = new PngDecoder(file, file.Length, name);
        byte[] pixels = new byte[png.Width * png.Height * 3];
        png.Decode(pixels);
        return new RgbPicture(png.Width, png.Height, pixels);
    }

    internal static uint GetNumber(byte[] data, int at)
        => ((uint)data[at] << 24) | ((uint)data[at + 1] << 16) | ((uint)data[at + 2] << 8) | data[at + 3];

    private static MemoryStream Compress(RgbPicture picture)
    {
        int rowLength = picture.Width * 3;
        byte[] line = new byte[rowLength + 1];
        byte[] pixels = picture.Pixels;
        var data = new MemoryStream();
        data.WriteByte(ZlibMethod);
        data.WriteByte(ZlibFlags);
        uint adler = 1;
        using (var deflate = new DeflateStream(data, CompressionLevel.Fastest, leaveOpen: true))
        {
            line[0] = FilterSub;
            for (int row = 0; row < picture.Height; row++)
            {
                int from = row * rowLength;
                for (int at = 0; at < rowLength; at++)
                    line[at + 1] = at < 3 ? pixels[from + at] : (byte)(pixels[from + at] - pixels[from + at - 3]);
                adler = Checksums.Adler32(adler, line, 0, line.Length);
                deflate.Write(line, 0, line.Length);
            }
        }

        byte[] sum = new byte[4];
        PutNumber(sum, 0, adler);
        data.Write(sum, 0, sum.Length);
        return data;
    }

    private static void WriteChunk(MemoryStream file, uint type, byte[] data, int length)
    {
        byte[] chunk = new byte[length + 12];
        PutNumber(chunk, 0, (uint)length);
        PutNumber(chunk, 4, type);
        Buffer.BlockCopy(data, 0, chunk, 8, length);
        PutNumber(chunk, length + 8, Checksums.Crc32(chunk, 4, length + 4));
        file.Write(chunk, 0, chunk.Length);
    }

    private static void PutNumber(byte[] data, int at, uint value)
    {
        data[at] = (byte)(value >> 24);
        data[at + 1] = (byte)(value >> 16);
        data[at + 2] = (byte)(value >> 8);
        data[at + 3] = (byte)value;
    }
}
