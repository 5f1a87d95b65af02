using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace Rabit.Geodesy;

/// <summary>
/// Reads a terrain grid from text: the ARC/INFO ASCII grid (.asc) in degrees of latitude and longitude, rows from the
/// north; cells may be given by `cellsize`, or by `dx` and `dy`.
/// </summary>
public static class AsciiGrid
{
    // A grid may cross the date line; metres of a projection are far beyond.
    private const double MaxDegrees = 720;
    private const int MaxPosts = 100_000_000;

    private static readonly char[] Blanks = [' ', '\t', '\r', '\n'];

    /// <summary>Reads a grid of altitudes above mean sea level to its end.</summary>
    /// <param name="reader">The text; stays open.</param>
    /// <exception cref="FormatException">It is not such a grid; the text says where.</exception>
    public static TerrainGrid Read(TextReader reader) => Read(reader, geoid: null);

    /// <summary>Reads a grid of heights above the ellipsoid to its end, and brings them above mean sea level.</summary>
    /// <param name="reader">The text; stays open.</param>
    /// <param name="geoid">How far the geoid is above the ellipsoid.</param>
    /// <exception cref="FormatException">It is not such a grid; the text says where.</exception>
    public static TerrainGrid ReadEllipsoidHeights(TextReader reader, GeoidGrid geoid)
        => Read(reader, geoid ?? throw new ArgumentNullException(nameof(geoid)));

    private static TerrainGrid Read(TextReader reader, GeoidGrid? geoid)
    {
        if (reader is null)
            throw new ArgumentNullException(nameof(reader));
        Dictionary<string, double> header = ReadHeader(reader, out string? line, out int lineNumber);
        int columns = Count(header, "ncols");
        int rows = Count(header, "nrows");
        if ((long)rows * columns > MaxPosts)
            throw new FormatException($"The grid of {rows} x {columns} posts is larger than {MaxPosts} posts.");
        double dx = CellSize(header, "dx");
        double dy = CellSize(header, "dy");
        double west = Corner(header, "xllcenter", "xllcorner", dx);
        double south = Corner(header, "yllcenter", "yllcorner", dy);
        if (Math.Abs(west) > MaxDegrees || Math.Abs(south) > MaxDegrees)
        {
            throw new FormatException(FormattableString.Invariant(
                $"The grid begins at {west}, {south}, which are no degrees: it must be in longitude and latitude, not projected."));
        }

        double noData = header.TryGetValue("nodata_value", out double none) ? none : -9999;

        var heights = new float[rows * columns];
        int count = 0;
        for (; line is not null; line = reader.ReadLine(), lineNumber++)
        {
            foreach (string word in line.Split(Blanks, StringSplitOptions.RemoveEmptyEntries))
            {
                if (!double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out double height))
                    throw new FormatException($"Line {lineNumber} of the grid: '{word}' is not a height.");
                if (count == heights.Length)
                    throw new FormatException(
                        $"Line {lineNumber} of the grid: there are more than {rows} x {columns} heights.");
                int index = ((rows - 1 - (count / columns)) * columns) + (count % columns);
                heights[index] = height == noData || double.IsInfinity(height) ? float.NaN : (float)height;
                count++;
            }
        }

        if (count != heights.Length)
            throw new FormatException($"The grid ends after {count} of {rows} x {columns} heights.");
        try
        {
            var corner = new GeographicPoint(Angle.FromDegrees(south), Angle.FromDegrees(west));
            (Angle latitudeStep, Angle longitudeStep) = (Angle.FromDegrees(dy), Angle.FromDegrees(dx));
            return geoid is null
                ? new TerrainGrid(corner, latitudeStep, longitudeStep, rows, columns, heights)
                : TerrainGrid.FromEllipsoidHeights(corner, latitudeStep, longitudeStep, rows, columns, heights, geoid);
        }
        catch (ArgumentException e)
        {
            throw new FormatException(e.Message, e);
        }
    }

    private static Dictionary<string, double> ReadHeader(TextReader reader, out string? line, out int lineNumber)
    {
        var header = new Dictionary<string, double>(StringComparer.OrdinalIgnoreCase);
        lineNumber = 1;
        while ((line = reader.ReadLine()) is not null)
        {
            string[] words = line.Split(Blanks, StringSplitOptions.RemoveEmptyEntries);
            bool isHeader = words.Length == 2 && char.IsLetter(words[0][0])
                && !double.TryParse(words[0], NumberStyles.Float, CultureInfo.InvariantCulture, out _);
            if (words.Length > 0 && !isHeader)
                break;
            if (isHeader && !double.TryParse(words[1], NumberStyles.Float, CultureInfo.InvariantCulture, out _))
                throw new FormatException($"Line {lineNumber} of the grid: '{words[1]}' is not a number.");
            if (isHeader)
                header[words[0]] = double.Parse(words[1], NumberStyles.Float, CultureInfo.InvariantCulture);
            lineNumber++;
        }

        return header;
    }

    private static int Count(Dictionary<string, double> header, string name)
    {
        double value = header.TryGetValue(name, out double found) ? found : throw Missing(name);
        return value >= 2 && value <= MaxPosts && value == Math.Floor(value)
            ? (int)value
            : throw new FormatException(FormattableString.Invariant($"The grid's {name} is {value}."));
    }

    private static double CellSize(Dictionary<string, double> header, string name)
        => header.TryGetValue("cellsize", out double size) || header.TryGetValue(name, out size)
            ? size
            : throw Missing("cellsize");

    // A cell's corner is half a cell from its post.
    private static double Corner(Dictionary<string, double> header, string centre, string corner, double cell)
    {
        if (header.TryGetValue(centre, out double value))
            return value;
        return header.TryGetValue(corner, out value) ? value + (cell / 2) : throw Missing(corner);
    }

    private static FormatException Missing(string name) => new($"The grid does not give its {name}.");
}
