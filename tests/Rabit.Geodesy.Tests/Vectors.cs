using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Tests.Shared;

namespace Rabit.Geodesy.Tests;

/// <summary>
/// Reference values that were made with other libraries (pyproj, scipy, OpenCV), in tests/data/autonomy; angles in
/// degrees.
/// </summary>
internal static class Vectors
{
    public const double Degree = Angle.RadiansPerDegree;

    // Not the base directory: where tests run without a domain of their own, as under Mono, that is the runner's.
    private static readonly string Folder = Path.Combine(
        Path.GetDirectoryName(typeof(Vectors).Assembly.Location)!, "data", "autonomy");

    private static readonly Lazy<JsonDocument> GeolocationFile = new(() => Open("geolocation.json"));
    private static readonly Lazy<JsonDocument> AttitudeFile = new(() => Open("attitude.json"));
    private static readonly Lazy<JsonDocument> GeodesyFile = new(() => Open("geodesy.json"));

    public static JsonElement Geolocation => GeolocationFile.Value.RootElement;

    public static JsonElement Geodesy => GeodesyFile.Value.RootElement;

    /// <summary>Whether the whole sets are beside the repository, of which tests/data/autonomy is a part.</summary>
    public static bool AreWhole => FullFolder is not null;

    /// <summary>Where larger sets are beside the repository; null where they are not.</summary>
    public static string? FullFolder { get; } = FindFullFolder();

    public static JsonElement Attitude => AttitudeFile.Value.RootElement;

    public static IEnumerable<JsonElement> Each(this JsonElement file, string list)
        => file.GetProperty(list).EnumerateArray();

    public static double Number(this JsonElement item, string name) => item.GetProperty(name).GetDouble();

    public static double Radians(this JsonElement item, string name) => item.Number(name) * Degree;

    public static string? Text(this JsonElement item, string name)
        => item.TryGetProperty(name, out JsonElement text) ? text.GetString() : null;

    public static double[] Numbers(this JsonElement item, string name)
        => item.GetProperty(name).EnumerateArray().Select(n => n.GetDouble()).ToArray();

    public static EulerAngles Euler(this JsonElement item)
        => EulerAngles.FromRadians(item.Radians("roll"), item.Radians("pitch"), item.Radians("yaw"));

    public static GeodeticPosition Position(this JsonElement item)
        => GeodeticPosition.FromRadians(item.Radians("lat"), item.Radians("lon"), item.Number("h"));

    /// <summary>Metres between two places, also across the date line.</summary>
    public static double Distance(GeodeticPosition a, GeodeticPosition b)
    {
        return NedPosition.Origin.DistanceTo(LocalNedFrame.IgnoringGeoid(a).ToNed(b));
    }

    /// <summary>A folder of the larger sets; null where it is not there.</summary>
    public static string? FolderOf(string name)
    {
        string root = Environment.GetEnvironmentVariable("RABIT_VECTORS")
            ?? Path.Combine(Repository.Root, "..", "shared", "vectors");
        string folder = Path.Combine(root, name);
        return Directory.Exists(folder) ? folder : null;
    }

    private static JsonDocument Open(string file)
        => JsonDocument.Parse(File.ReadAllText(Path.Combine(FullFolder ?? Folder, file)));

    private static string? FindFullFolder()
        => FolderOf("autonomy") is { } folder && File.Exists(Path.Combine(folder, "geodesy.json")) ? folder : null;
}
