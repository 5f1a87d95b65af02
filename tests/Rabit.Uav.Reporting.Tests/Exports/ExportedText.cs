using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using System.Xml.Linq;
using Xunit;

namespace Rabit.Uav.Reporting.Tests;

/// <summary>Reads what was exported with general readers of its format.</summary>
internal static class ExportedText
{
    public static string Text(Action<Stream, FlightSummary> write, FlightSummary summary)
    {
        using var stream = new MemoryStream();
        write(stream, summary);
        return new UTF8Encoding(false, throwOnInvalidBytes: true).GetString(stream.ToArray());
    }

    public static JsonElement[] Features(FlightSummary summary)
    {
        JsonElement root = JsonDocument.Parse(Text(FlightExport.WriteGeoJson, summary)).RootElement;
        Assert.Equal("FeatureCollection", root.GetProperty("type").GetString());
        JsonElement[] features = [.. root.GetProperty("features").EnumerateArray()];
        Assert.All(features, f => Assert.Equal("Feature", f.GetProperty("type").GetString()));
        return features;
    }

    public static string KindOf(JsonElement feature)
        => feature.GetProperty("properties").GetProperty("kind").GetString()!;

    public static int NumberOf(JsonElement feature)
        => feature.GetProperty("properties").GetProperty("number").GetInt32();

    public static IEnumerable<JsonElement> PolygonsOf(JsonElement geometry)
        => geometry.GetProperty("type").GetString() switch
        {
            "Polygon" => [geometry.GetProperty("coordinates")],
            "MultiPolygon" => geometry.GetProperty("coordinates").EnumerateArray(),
            _ => [],
        };

    public static double[][] PositionsOf(JsonElement geometry)
        => [.. Flatten(geometry.GetProperty("coordinates"))];

    public static IEnumerable<double[]> Flatten(JsonElement coordinates)
        => coordinates[0].ValueKind == JsonValueKind.Number
            ? [Numbers(coordinates)]
            : coordinates.EnumerateArray().SelectMany(Flatten);

    public static double[] Numbers(JsonElement position)
        => [.. position.EnumerateArray().Select(n => n.GetDouble())];

    public static double SignedArea(double[][] ring)
        => Enumerable.Range(0, ring.Length - 1).Sum(i =>
            ((ring[i][0] - ring[0][0]) * (ring[i + 1][1] - ring[0][1]))
                - ((ring[i + 1][0] - ring[0][0]) * (ring[i][1] - ring[0][1]))) / 2;

    public static bool IsInside(double[][] ring, double x, double y)
        => Enumerable.Range(0, ring.Length - 1).Count(i => ring[i][1] > y != ring[i + 1][1] > y
            && x < ring[i][0] + ((ring[i + 1][0] - ring[i][0]) * (y - ring[i][1]) / (ring[i + 1][1] - ring[i][1]))) % 2
            == 1;

    public static double[][] Places(XElement coordinates)
        => [.. coordinates.Value.Split(' ').Select(p => p.Split(',').Select(Number).ToArray())];

    public static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
