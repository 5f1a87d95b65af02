using System;
using System.IO;
using System.Linq;
using Rabit.Uav.Reporting;

namespace UavConsole;

/// <summary>The formats of <c>--export</c>, by the end of the file's name.</summary>
internal static class ExportFormat
{
    private static readonly (string Ending, Action<Stream, FlightSummary> Write)[] Known =
    [
        (".geojson", FlightExport.WriteGeoJson), (".kml", FlightExport.WriteKml), (".csv", FlightExport.WriteCsv),
    ];

    /// <summary>For people.</summary>
    public static string Endings
        => string.Join(", ", Known.Take(Known.Length - 1).Select(k => k.Ending)) + " or " + Known.Last().Ending;

    /// <returns>What writes such a file; null for another end.</returns>
    public static Action<Stream, FlightSummary>? Find(string path)
        => Known.FirstOrDefault(k => path.EndsWith(k.Ending, StringComparison.OrdinalIgnoreCase)).Write;
}
