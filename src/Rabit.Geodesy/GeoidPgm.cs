using System;
using System.Globalization;
using System.IO;
using System.Text;

namespace Rabit.Geodesy;

/// <summary>
/// Reads a geoid grid in the format of GeographicLib: a 16-bit PGM picture whose comments give Offset and Scale, as the
/// files egm96-15.pgm, egm96-5.pgm and egm2008-5.pgm of its distribution (package geographiclib-datasets of Debian).
/// Between posts it is interpolated bilinearly: for egm96-15 within 1.2 m (4 cm RMS), for egm96-5 within 0.14 m (5 mm
/// RMS) of the model.
/// </summary>
/// <remarks>Format: C. F. F. Karney, GeographicLib, "Geoid height", "The format of the geoid data files".</remarks>
public static class GeoidPgm
{
    // egm2008-1 has 21600 columns; whatever has more is no geoid.
    private const int MaxColumns = 43_200;
    private const int MaxHeaderLine = 1000;

    /// <summary>
    /// Reads it to its end. It takes two bytes of memory for each post: 2 MB for 15 minutes of arc, 19 MB for 5.
    /// </summary>
    /// <param name="stream">The file; stays open.</param>
    /// <exception cref="FormatException">It is not such a grid; the text says why.</exception>
    public static GeoidGrid Read(Stream stream)
    {
        if (stream is null)
            throw new ArgumentNullException(nameof(stream));
        using var reader = new BinaryReader(stream, Encoding.ASCII, leaveOpen: true);
        if (ReadLine(reader) != "P5")
            throw new FormatException("The geoid grid is no binary PGM file: it does not begin with P5.");
        (double offset, double scale) = (double.NaN, double.NaN);
        string line = ReadLine(reader);
        for (; line.Length > 0 && line[0] == '#'; line = ReadLine(reader))
        {
            string[] words = line.Split([' ', '\t', '#'], StringSplitOptions.RemoveEmptyEntries);
            if (words.Length >= 2 && words[0] == "Offset")
                offset = Number(words[1], "Offset");
            else if (words.Length >= 2 && words[0] == "Scale")
                scale = Number(words[1], "Scale");
            else if (words.Length >= 3 && words[0] == "Origin" && (words[1] != "90N" || words[2] != "0E"))
                throw new FormatException($"The geoid grid begins at {words[1]} {words[2]}, not at 90N 0E.");
        }

        if (double.IsNaN(offset) || !(scale > 0))
            throw new FormatException("The geoid grid's comments do not give Offset and a positive Scale.");
        (int columns, int rows) = Size(line);
        if (ReadLine(reader) != "65535")
            throw new FormatException(
                "The geoid grid does not have 16 bits for each post: its largest value is not 65535.");
        return new GeoidGrid(GeoidPosts.Read(reader, rows, columns), rows, columns, offset, scale);
    }

    private static (int Columns, int Rows) Size(string line)
    {
        string[] words = line.Split([' '], StringSplitOptions.RemoveEmptyEntries);
        if (words.Length != 2
            || !int.TryParse(words[0], NumberStyles.None, CultureInfo.InvariantCulture, out int columns)
            || !int.TryParse(words[1], NumberStyles.None, CultureInfo.InvariantCulture, out int rows))
            throw new FormatException($"The geoid grid's size is '{line}', not two numbers.");
        if (columns is < 2 or > MaxColumns || rows != (columns / 2) + 1 || columns % 2 != 0)
            throw new FormatException(
                $"A geoid grid of {columns} x {rows} posts does not go round the earth: "
                    + "its rows are half its columns and 1.");
        return (columns, rows);
    }

    private static double Number(string word, string name)
        => double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out double number)
            && FiniteNumbers.IsFinite(number)
            ? number
            : throw new FormatException($"The geoid grid's {name} is '{word}', not a number.");

    private static string ReadLine(BinaryReader reader)
    {
        var line = new StringBuilder();
        try
        {
            for (char next = (char)reader.ReadByte(); next != '\n'; next = (char)reader.ReadByte())
            {
                if (line.Length == MaxHeaderLine)
                    throw new FormatException("The geoid grid has a header line without an end.");
                line.Append(next);
            }
        }
        catch (EndOfStreamException e)
        {
            throw new FormatException("The geoid grid ends within its header.", e);
        }

        return line.ToString().TrimEnd('\r');
    }
}
