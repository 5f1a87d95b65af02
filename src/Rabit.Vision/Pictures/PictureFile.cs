using System;
using System.Globalization;
using System.IO;
using System.Text;

namespace Rabit.Vision;

/// <summary>
/// Pictures in files: reads what <see cref="PictureReader"/> does, which is for many, one after the other; writes PNG
/// and binary PPM (P6), 8 bits per channel. Any thread.
/// </summary>
/// <example>
/// <code>
/// RgbPicture picture = PictureFile.Load("in.png");
/// PictureFile.Save("out.ppm", picture);
/// </code>
/// </example>
public static class PictureFile
{
    /// <summary>Reads a picture.</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="PictureException">
    /// There is no such file, it may not be read, it is of a kind that is not read, or damaged.
    /// </exception>
    public static RgbPicture Load(string path) => new PictureReader().Load(path);

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

    internal static bool IsFileFault(Exception e)
        => e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException;
}
