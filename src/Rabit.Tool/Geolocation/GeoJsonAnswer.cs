using System;
using System.Collections.Generic;
using System.IO;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing.Geolocation;

namespace Rabit.Tool.Geolocation;

/// <summary>
/// Places as GeoJSON, RFC 7946, for maps: a point for each pixel and its 95 % ellipse; of a refused one no geometry. A
/// third coordinate would be a height above the ellipsoid, which is not known: the altitude is a property.
/// </summary>
internal sealed class GeoJsonAnswer
{
    private const int MetreDecimals = 3;

    private readonly Utf8JsonWriter _json;

    private GeoJsonAnswer(Utf8JsonWriter json) => _json = json;

    public static void Write(Stream output, IReadOnlyList<LocatedPixel> pixels)
    {
        using var json = new Utf8JsonWriter(output);
        var answer = new GeoJsonAnswer(json);
        json.WriteStartObject();
        json.WriteString("type", "FeatureCollection");
        json.WriteStartArray("features");
        foreach (LocatedPixel pixel in pixels)
            answer.Write(pixel);
        json.WriteEndArray();
        json.WriteEndObject();
    }

    private void Write(LocatedPixel pixel)
    {
        GeolocationResult fix = pixel.Result;
        BeginFeature("pixel", pixel);
        _json.WriteString("status", pixel.IsLocated ? "ok" : "refused");
        if (!pixel.IsLocated)
        {
            _json.WriteString("reason", fix.Error.ToString());
            _json.WriteString("text", Answer.Reason(fix.Error));
            _json.WriteEndObject();
            _json.WriteNull("geometry");
            _json.WriteEndObject();
            return;
        }

        HorizontalCovariance all = fix.Covariance + fix.SystematicCovariance;
        WriteNumber("altitudeAmslMetres", fix.Position.AltitudeAmslMetres, MetreDecimals);
        WriteNumber("ellipse95HalfMajorAxisMetres", all.HalfMajorAxis95Metres, MetreDecimals);
        WriteNumber("ellipse95HalfMinorAxisMetres", all.HalfMinorAxis95Metres, MetreDecimals);
        WriteNumber("ellipseMajorAxisDegrees", all.MajorAxis.Degrees, 2);
        BeginGeometry("Point");
        WritePosition(fix.Position.Longitude.Degrees, fix.Position.Latitude.Degrees);
        EndFeature();
        WriteEllipse(pixel, EllipseRing.Of(fix.Position, all));
    }

    private void WriteEllipse(
        LocatedPixel pixel, IReadOnlyList<IReadOnlyList<(double Longitude, double Latitude)>> rings)
    {
        if (rings.Count == 0)
            return;
        BeginFeature("ellipse95", pixel);
        BeginGeometry(rings.Count == 1 ? "Polygon" : "MultiPolygon");
        if (rings.Count > 1)
            _json.WriteStartArray();
        foreach (IReadOnlyList<(double Longitude, double Latitude)> ring in rings)
            WritePolygon(ring);
        if (rings.Count > 1)
            _json.WriteEndArray();
        EndFeature();
    }

    // Properties are written between the two.
    private void BeginFeature(string kind, LocatedPixel pixel)
    {
        _json.WriteStartObject();
        _json.WriteString("type", "Feature");
        _json.WriteStartObject("properties");
        _json.WriteString("kind", kind);
        _json.WriteStartArray("pixel");
        _json.WriteNumberValue(pixel.Column);
        _json.WriteNumberValue(pixel.Row);
        _json.WriteEndArray();
    }

    private void BeginGeometry(string type)
    {
        _json.WriteEndObject();
        _json.WriteStartObject("geometry");
        _json.WriteString("type", type);
        _json.WritePropertyName("coordinates");
    }

    private void EndFeature()
    {
        _json.WriteEndObject();
        _json.WriteEndObject();
    }

    private void WritePolygon(IReadOnlyList<(double Longitude, double Latitude)> ring)
    {
        _json.WriteStartArray();
        _json.WriteStartArray();
        foreach ((double longitude, double latitude) in ring)
            WritePosition(longitude, latitude);
        _json.WriteEndArray();
        _json.WriteEndArray();
    }

    // To a centimetre.
    private void WritePosition(double longitudeDegrees, double latitudeDegrees)
    {
        _json.WriteStartArray();
        _json.WriteNumberValue((decimal)Math.Round(longitudeDegrees, 7));
        _json.WriteNumberValue((decimal)Math.Round(latitudeDegrees, 7));
        _json.WriteEndArray();
    }

    // JSON has no NaN.
    private void WriteNumber(string name, double value, int decimals)
    {
        if (Math.Abs(value) < 1e15)
            _json.WriteNumber(name, (decimal)Math.Round(value, decimals));
        else
            _json.WriteNull(name);
    }
}
