using System;
using System.Globalization;
using System.IO;
using System.Linq;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// What the name of a camera's picture says: "f000123_1732190000123456_e2000.png" is picture 123, its exposure began
/// that many microseconds after 1970, UTC, and took 2000 microseconds. A plain value.
/// </summary>
internal readonly struct PictureFileName(long number, long startUtcMicroseconds, long exposureMicroseconds)
{
    // The last microsecond that a date of .NET can hold, at the end of the year 9999; and an exposure of an hour.
    private const long LastMicrosecond = 253_402_300_799_999_999;
    private const long MaxExposure = 3_600_000_000;

    private static readonly string[] PictureEndings = [".png", ".ppm", ".pgm", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff"];

    public long Number { get; } = number;

    public long StartUtcMicroseconds { get; } = startUtcMicroseconds;

    public long ExposureMicroseconds { get; } = exposureMicroseconds;

    public string ToFileName() => string.Format(
        CultureInfo.InvariantCulture, "f{0:D6}_{1}_e{2}.png", Number, StartUtcMicroseconds, ExposureMicroseconds);

    /// <summary>Whether numbers are such as a picture may have.</summary>
    public static bool IsPossible(long startUtcMicroseconds, long exposureMicroseconds)
        => startUtcMicroseconds is >= 0 and <= LastMicrosecond && exposureMicroseconds is >= 0 and <= MaxExposure;

    /// <summary>Whether a file says that it is a picture, of whatever kind.</summary>
    public static bool IsPicture(string fileName)
        => PictureEndings.Contains(Path.GetExtension(fileName), StringComparer.OrdinalIgnoreCase);

    /// <summary>Reads a name; false for any other file.</summary>
    public static bool TryParse(string fileName, out PictureFileName name)
    {
        name = default;
        if (!IsPicture(fileName))
            return false;
        string[] parts = fileName.Substring(0, fileName.Length - Path.GetExtension(fileName).Length).Split('_');
        if (parts.Length != 3 || !TryNumber(parts[0], "f", out long number)
            || !TryNumber(parts[1], string.Empty, out long start)
            || !TryNumber(parts[2], "e", out long exposure) || !IsPossible(start, exposure))
        {
            return false;
        }

        name = new PictureFileName(number, start, exposure);
        return true;
    }

    private static bool TryNumber(string part, string prefix, out long number)
    {
        number = 0;
        if (part.Length == prefix.Length || !part.StartsWith(prefix, StringComparison.Ordinal))
            return false;
        for (int at = prefix.Length; at < part.Length; at++)
        {
            int digit = part[at] - '0';
            if (digit is < 0 or > 9 || number > (long.MaxValue - digit) / 10)
                return false;
            number = (number * 10) + digit;
        }

        return true;
    }
}
