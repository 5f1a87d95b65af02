using System;
using System.Globalization;
using System.IO;
using System.Text;

namespace Rabit.Vision;

/// <summary>
/// Pictures in files: PNG and binary PPM (P6), 8 bits per channel. What a file is, its first bytes say, not its name.
/// Any thread.
/// </summary>
/// <example>
/// <code>
/// RgbPicture picture = PictureFile.Load("in.png");
/// PictureFile.Save("out.ppm", picture);
/// </code>
/// </example>
public static class PictureFile
{
    // Larger than any picture that is read here: nothing is gained by packing pixels into more bytes than they have.
    private const long MaxFileBytes = 256L * 1024 * 1024;

    /// <summary>Reads a picture.</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="PictureException">
    /// There is no such file, it may not be read, it is of a kind that is not read, or damaged.
    /// </exception>
    public static RgbPicture Load(string path)
    {
        byte[]? buffer = null;
        int length = ReadAll(path, ref buffer);
        if (IsPpm(buffer!, length))
        {
            var ppm = new PpmDecoder(buffer!, length, path);
            byte[] pixels = new byte[ppm.Width * ppm.Height * 3];
            ppm.Decode(pixels);
            return new RgbPicture(ppm.Width, ppm.Height, pixels);
        }
        else
        {
            PngDecoder png = OpenPng(path, buffer!, length);
            byte[] pixels = new byte[png.Width * png.Height * 3];
            png.Decode(pixels);
            return new RgbPicture(png.Width, png.Height, pixels);
        }
    }

    /// <summary>
    /// Writes a picture, as PPM if the name ends in ".ppm", else as PNG. A file of that name is replaced.
    /// </summary>
    /// <param name="path">The file.</param>
    /// <param name="picture">The picture.</param>
    /// <exception cref="PictureException">The file cannot be written.</exception>
    public static void Save(string path, RgbPicture picture)
    {
        if (picture is null)
            throw new ArgumentNullException(nameof(picture));
        bool isPpm = path.EndsWith(".ppm", StringComparison.OrdinalIgnoreCase);
        byte[] header = isPpm
            ? Encoding.ASCII.GetBytes(
                string.Format(CultureInfo.InvariantCulture, "P6\n{0} {1}\n255\n", picture.Width, picture.Height))
            : PngPicture.Encode(picture);
        try
        {
            using var file = new FileStream(path, FileMode.Create, FileAccess.Write, FileShare.None);
            file.Write(header, 0, header.Length);
            if (isPpm)
                file.Write(picture.Pixels, 0, picture.Width * picture.Height * 3);
        }
        catch (Exception e) when (IsFileFault(e))
        {
            throw new PictureException(path, "it cannot be written: " + e.Message, e);
        }
    }

    /// <summary>Reads a picture of a known size.</summary>
    /// <param name="path">The file.</param>
    /// <param name="width">Columns it must have.</param>
    /// <param name="height">Rows it must have.</param>
    /// <param name="pixels">Takes red, green and blue.</param>
    /// <param name="buffer">For the bytes of the file; kept by the caller from one to the next.</param>
    /// <exception cref="PictureException">As for <see cref="Load"/>, or another size.</exception>
    public static void LoadInto(string path, int width, int height, byte[] pixels, ref byte[]? buffer)
    {
        int length = ReadAll(path, ref buffer);
        if (IsPpm(buffer!, length))
        {
            var ppm = new PpmDecoder(buffer!, length, path);
            DemandSize(path, ppm.Width, ppm.Height, width, height);
            ppm.Decode(pixels);
        }
        else
        {
            PngDecoder png = OpenPng(path, buffer!, length);
            DemandSize(path, png.Width, png.Height, width, height);
            png.Decode(pixels);
        }
    }

    internal static bool IsFileFault(Exception e)
        => e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException;

    private static void DemandSize(string path, int width, int height, int wantedWidth, int wantedHeight)
    {
        if (width != wantedWidth || height != wantedHeight)
            throw new PictureException(
                path, $"it is {width} x {height} pixels; those of its camera are {wantedWidth} x {wantedHeight}");
    }

    private static PngDecoder OpenPng(string path, byte[] file, int length)
    {
        if (length == 0)
            throw new PictureException(path, "the file is empty");
        if (length >= 2 && file[0] == 0xFF && file[1] == 0xD8)
            throw new PictureException(path, "that is a JPEG; only PNG and binary PPM (P6) are read");
        if (file[0] != PngPicture.Signature[0])
            throw new PictureException(path, "that is no picture that is read here; only PNG and binary PPM (P6) are");
        return new PngDecoder(file, length, path);
    }

    private static bool IsPpm(byte[] file, int length) => length >= 2 && file[0] == 'P' && file[1] == '6';

    private static int ReadAll(string path, ref byte[]? buffer)
    {
        try
        {
            using var file = new FileStream(
                path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
            if (file.Length > MaxFileBytes)
                throw new PictureException(path, $"it has {file.Length} bytes; at most {MaxFileBytes} are read");
            int length = (int)file.Length;
            if (buffer is null || buffer.Length < length)
                buffer = new byte[length];
            int filled = 0;
            while (filled < length)
            {
                int read = file.Read(buffer, filled, length - filled);
                if (read <= 0)
                    break;
                filled += read;
            }

            return filled;
        }
        catch (Exception e) when (IsFileFault(e))
        {
            string reason = e switch
            {
                FileNotFoundException or DirectoryNotFoundException => "no such file",
                UnauthorizedAccessException => Directory.Exists(path) ? "that is a folder" : "no permission to read it",
                _ => "it cannot be read: " + e.Message,
            };
            throw new PictureException(path, reason, e);
        }
    }
}
