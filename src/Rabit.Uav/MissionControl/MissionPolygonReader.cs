using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.Json;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Reads the polygons of a mission file: a list of corners [latitude, longitude], or a GeoJSON Polygon (RFC 7946), or a
/// Feature with one, whose positions are [longitude, latitude] and whose rings repeat their first position.
/// </summary>
internal static class MissionPolygonReader
{
    private const string CornersForm = "must be [latitude, longitude] in degrees";
    private const string GeoJsonForm = "must be a list of corners or a GeoJSON Polygon";

    /// <summary>The outer border, and the holes, of a polygon; empty where it could not be read.</summary>
    public static ImmutableArray<ImmutableArray<GeodeticPosition>> Read(
        JsonFields fields, string path, JsonElement value)
    {
        if (value.ValueKind == JsonValueKind.Array)
            return [ReadRing(fields, path, value, isGeoJson: false)];
        JsonElement polygon = value;
        if (TypeOf(polygon) == "Feature" && polygon.TryGetProperty("geometry", out JsonElement geometry))
            polygon = geometry;
        if (TypeOf(polygon) is not { } type)
        {
            fields.Blame(path, value, GeoJsonForm);
            return [];
        }

        if (type != "Polygon" || !polygon.TryGetProperty("coordinates", out JsonElement rings)
            || rings.ValueKind != JsonValueKind.Array || rings.GetArrayLength() == 0)
        {
            fields.Blame(path, value, $"{GeoJsonForm} with coordinates, not a {type}");
            return [];
        }

        return rings.EnumerateArray()
            .Select((ring, i) => ReadRing(fields, Item(path + ".coordinates", i), ring, isGeoJson: true))
            .ToImmutableArray();
    }

    public static string Item(string list, int index)
        => string.Format(CultureInfo.InvariantCulture, "{0}[{1}]", list, index);

    private static string? TypeOf(JsonElement value)
        => value.ValueKind == JsonValueKind.Object && value.TryGetProperty("type", out JsonElement type)
            && type.ValueKind == JsonValueKind.String ? type.GetString() : null;

    private static ImmutableArray<GeodeticPosition> ReadRing(
        JsonFields fields, string path, JsonElement ring, bool isGeoJson)
    {
        if (ring.ValueKind != JsonValueKind.Array)
        {
            fields.Blame(path, ring, "must be a list of positions");
            return [];
        }

        var corners = new List<GeodeticPosition>();
        int index = 0;
        foreach (JsonElement corner in ring.EnumerateArray())
        {
            if (ReadCorner(corner, isGeoJson) is { } position)
                corners.Add(position);
            else
            {
                fields.Blame(
                    Item(path, index), corner,
                    isGeoJson ? "must be [longitude, latitude] in degrees" : CornersForm);
            }

            index++;
        }

        if (isGeoJson && corners.Count > 1 && AreSame(corners[0], corners[corners.Count - 1]))
            corners.RemoveAt(corners.Count - 1);
        return corners.ToImmutableArray();
    }

    // A position of GeoJSON may have an altitude.
    private static GeodeticPosition? ReadCorner(JsonElement corner, bool isGeoJson)
    {
        if (corner.ValueKind != JsonValueKind.Array)
            return null;
        int count = corner.GetArrayLength();
        if ((count != 2 && !(isGeoJson && count == 3)) || corner[0].ValueKind != JsonValueKind.Number
            || corner[1].ValueKind != JsonValueKind.Number || !corner[0].TryGetDouble(out double first)
            || !corner[1].TryGetDouble(out double second))
            return null;
        (double latitude, double longitude) = isGeoJson ? (second, first) : (first, second);
        return Math.Abs(latitude) <= 90 && Math.Abs(longitude) <= 180
            ? GeodeticPosition.FromDegrees(latitude, longitude, 0)
            : null;
    }

    private static bool AreSame(in GeodeticPosition a, in GeodeticPosition b)
        => a.Latitude.Radians.Equals(b.Latitude.Radians) && a.Longitude.Radians.Equals(b.Longitude.Radians);
}
