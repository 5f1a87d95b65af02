using System;
using System.IO;
using Rabit.Uav.Reporting.Exports;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Writes a flight for maps and tables: path, targets with their 95 % ellipses, area, fence, lanes and the ground that
/// was seen, as GeoJSON, KML or CSV. Positions are WGS 84; numbers of targets are those of their tracks, as in the
/// report.
/// </summary>
/// <example>
/// <code>
/// using FileStream map = File.Create("flight.geojson");
/// FlightExport.WriteGeoJson(map, summary);
/// </code>
/// </example>
public static class FlightExport
{
    /// <summary>
    /// Writes GeoJSON (RFC 7946): a FeatureCollection; the property <c>kind</c> says what a feature is. Positions have
    /// no third number, which in GeoJSON is a height above the ellipsoid: altitudes above mean sea level are
    /// properties.
    /// </summary>
    /// <param name="output">Where to; it is not closed.</param>
    /// <param name="summary">The flight.</param>
    /// <example>
    /// <code>
    /// using var map = new MemoryStream();
    /// FlightExport.WriteGeoJson(map, summary);
    /// </code>
    /// </example>
    public static void WriteGeoJson(Stream output, FlightSummary summary)
        => GeoJsonExport.Write(Checked(output, nameof(output)), Checked(summary, nameof(summary)));

    /// <summary>Writes KML 2.2; altitudes are above mean sea level, as KML has them.</summary>
    /// <param name="output">Where to; it is not closed.</param>
    /// <param name="summary">The flight.</param>
    /// <example>
    /// <code>
    /// using FileStream globe = File.Create("flight.kml");
    /// FlightExport.WriteKml(globe, summary);
    /// </code>
    /// </example>
    public static void WriteKml(Stream output, FlightSummary summary)
        => KmlExport.Write(Checked(output, nameof(output)), Checked(summary, nameof(summary)));

    /// <summary>
    /// Writes one table as CSV (RFC 4180, UTF-8, a point in numbers): the column <c>kind</c> says what a row is, the
    /// names of the columns carry the units; a field that does not apply is empty.
    /// </summary>
    /// <param name="output">Where to; it is not closed.</param>
    /// <param name="summary">The flight.</param>
    /// <example>
    /// <code>
    /// using FileStream table = File.Create("flight.csv");
    /// FlightExport.WriteCsv(table, summary);
    /// </code>
    /// </example>
    public static void WriteCsv(Stream output, FlightSummary summary)
        => CsvExport.Write(Checked(output, nameof(output)), Checked(summary, nameof(summary)));

    private static T Checked<T>(T? value, string name)
        where T : class
        => value ?? throw new ArgumentNullException(name);
}
