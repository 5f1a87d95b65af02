using System.Collections.Generic;
using System.IO;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.ImageProcessing.Geolocation;
using Rabit.Uav.Reporting.Exports;

namespace Rabit.Tool.Geolocation;

/// <summary>
/// Places as GeoJSON, RFC 7946, for maps: a point for each pixel and its 95 % ellipse; of a refused one no geometry. A
/// third coordinate would be a height above the ellipsoid, which is not known: the altitude is a property.
/// </summary>
internal sealed class GeoJsonAnswer
{
    private const int MetreDecimals = 3;

    private readonly Utf8JsonWriter _json;
    private readonly GeoJsonFeatures _features;

    private GeoJsonAnswer(Utf8JsonWriter json) => (_json, _features) = (json, new GeoJsonFeatures(json));

    public static void Write(Stream output, IReadOnlyList<LocatedPixel> pixels)
    {
        using var json = new Utf8JsonWriter(output);
        var answer = new GeoJsonAnswer(json);
        answer._features.BeginCollection();
        foreach (LocatedPixel pixel in pixels)
            answer.Write(pixel);
        answer._features.EndCollection();
    }

    private void Write(LocatedPixel pixel)
    {
        GeolocationResult fix = pixel.Result;
        Begin("pixel", pixel);
        _json.WriteString("status", pixel.IsLocated ? "ok" : "refused");
        if (!pixel.IsLocated)
        {
            _json.WriteString("reason", fix.Error.ToString());
            _json.WriteString("text", Answer.Reason(fix.Error));
            _features.EndWithoutGeometry();
            return;
        }

        HorizontalCovariance all = fix.Covariance + fix.SystematicCovariance;
        _features.WriteNumber("altitudeAmslMetres", fix.Position.AltitudeAmslMetres, MetreDecimals);
        _features.WriteNumber("ellipse95HalfMajorAxisMetres", all.HalfMajorAxis95Metres, MetreDecimals);
        _features.WriteNumber("ellipse95HalfMinorAxisMetres", all.HalfMinorAxis95Metres, MetreDecimals);
        _features.WriteNumber("ellipseMajorAxisDegrees", all.MajorAxis.Degrees, 2);
        _features.BeginGeometry("Point");
        _features.WritePosition(fix.Position.Longitude.Degrees, fix.Position.Latitude.Degrees);
        _features.End();
        WriteEllipse(pixel, EllipseRing.Of(fix.Position, all));
    }

    private void WriteEllipse(
        LocatedPixel pixel, IReadOnlyList<IReadOnlyList<(double Longitude, double Latitude)>> rings)
    {
        if (rings.Count == 0)
            return;
        Begin("ellipse95", pixel);
        _features.BeginGeometry(rings.Count == 1 ? "Polygon" : "MultiPolygon");
        if (rings.Count > 1)
            _json.WriteStartArray();
        foreach (IReadOnlyList<(double Longitude, double Latitude)> ring in rings)
            WritePolygon(ring);
        if (rings.Count > 1)
            _json.WriteEndArray();
        _features.End();
    }

    private void Begin(string kind, LocatedPixel pixel)
    {
        _features.Begin(kind);
        _json.WriteStartArray("pixel");
        _json.WriteNumberValue(pixel.Column);
        _json.WriteNumberValue(pixel.Row);
        _json.WriteEndArray();
    }

    private void WritePolygon(IReadOnlyList<(double Longitude, double Latitude)> ring)
    {
        _json.WriteStartArray();
        _json.WriteStartArray();
        foreach ((double longitude, double latitude) in ring)
            _features.WritePosition(longitude, latitude);
        _json.WriteEndArray();
        _json.WriteEndArray();
    }
}
