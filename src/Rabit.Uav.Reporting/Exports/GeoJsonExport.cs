using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Exports;

/// <summary>
/// GeoJSON, RFC 7946: longitude before latitude, rings closed, outlines counter-clockwise, holes clockwise.
/// </summary>
internal sealed class GeoJsonExport
{
    private readonly Utf8JsonWriter _json;
    private readonly ExportedFlight _flight;

    private GeoJsonExport(Utf8JsonWriter json, ExportedFlight flight) => (_json, _flight) = (json, flight);

    public static void Write(Stream output, FlightSummary summary)
    {
        using var json = new Utf8JsonWriter(output);
        new GeoJsonExport(json, new ExportedFlight(summary)).Write();
    }

    private void Write()
    {
        _json.WriteStartObject();
        _json.WriteString("type", "FeatureCollection");
        _json.WriteStartArray("features");
        WritePlan();
        WriteSeenGround();
        WritePath();
        foreach (TargetTrack target in _flight.Targets)
            WriteTarget(target);
        foreach (TargetScore truth in _flight.Truth)
            WriteTruth(truth);
        _json.WriteEndArray();
        _json.WriteEndObject();
    }

    private void WritePlan()
    {
        if (_flight.Plan is not { } plan)
            return;
        BeginFeature("home");
        _json.WriteString("name", _flight.Name);
        WriteNumber("altitudeAmslMetres", plan.Home.AltitudeAmslMetres, 2);
        BeginGeometry("Point");
        WritePosition(plan.Home);
        EndFeature();
        foreach ((string kind, IReadOnlyList<GeodeticPosition> corners) in _flight.Polygons())
        {
            BeginFeature(kind);
            BeginGeometry("Polygon");
            WritePolygon(ExportedFlight.Ring(corners), []);
            EndFeature();
        }

        int number = 0;
        foreach ((GeodeticPosition start, GeodeticPosition end) in _flight.Lanes())
        {
            BeginFeature("lane");
            _json.WriteNumber("number", ++number);
            BeginGeometry("LineString");
            WritePositions([start, end]);
            EndFeature();
        }
    }

    private void WriteSeenGround()
    {
        if (_flight.SeenGround() is not { Count: > 0 } patches)
            return;
        BeginFeature("coverage");
        WriteNumber("coveragePercent", _flight.CoveragePercent, 2);
        BeginGeometry("MultiPolygon");
        _json.WriteStartArray();
        foreach (SeenPatch patch in patches)
            WritePolygon(
                ExportedFlight.Ring(patch.Outline),
                patch.Holes.Select(h => ExportedFlight.Ring(h, isHole: true)));
        _json.WriteEndArray();
        EndFeature();
    }

    // A line has two places at least. One entry of each array for each place.
    private void WritePath()
    {
        IReadOnlyList<FlightSample> path = _flight.Path;
        if (path.Count < 2)
            return;
        BeginFeature("path");
        WriteArray("timeSeconds", path.Select(s => s.Time.TotalSeconds), 3);
        WriteArray("altitudeAmslMetres", path.Select(s => s.Position.AltitudeAmslMetres), 2);
        WriteArray("heightAboveHomeMetres", path.Select(s => s.HeightAboveHomeMetres), 2);
        BeginGeometry("LineString");
        WritePositions(path.Select(s => s.Position));
        EndFeature();
    }

    private void WriteTarget(TargetTrack target)
    {
        BeginFeature("target");
        WriteTargetFacts(target);
        WriteNumber("ellipse95HalfMajorAxisMetres", target.Covariance.HalfMajorAxis95Metres, 3);
        WriteNumber("ellipse95HalfMinorAxisMetres", target.Covariance.HalfMinorAxis95Metres, 3);
        WriteNumber("ellipseMajorAxisDegrees", target.Covariance.MajorAxis.Degrees, 2);
        _json.WriteNumber("reports", target.Reports);
        if (target.Bearing is { } bearing)
        {
            WriteNumber("bearingDegrees", bearing.Angle.Degrees, 2);
            WriteNumber("bearingDeviationDegrees", bearing.TotalSigma.Degrees, 2);
            _json.WriteString("bearingSymmetry", bearing.Symmetry.ToString());
        }

        WriteNumber("firstSeenSeconds", target.FirstSeen.TotalSeconds, 3);
        WriteNumber("lastSeenSeconds", target.LastSeen.TotalSeconds, 3);
        BeginGeometry("Point");
        WritePosition(target.Position);
        EndFeature();
        if (ExportedFlight.Ellipse(target) is not { Count: > 0 } ellipse)
            return;
        BeginFeature("ellipse95");
        WriteTargetFacts(target);
        BeginGeometry("Polygon");
        WritePolygon(ExportedFlight.Ring(ellipse), []);
        EndFeature();
    }

    private void WriteTargetFacts(TargetTrack target)
    {
        _json.WriteNumber("number", target.Id);
        _json.WriteString("class", ExportedFlight.Printable(TargetClassNames.Name(target.Class)));
        _json.WriteString("state", ExportedFlight.StateOf(target));
    }

    private void WriteTruth(TargetScore truth)
    {
        BeginFeature("truth");
        _json.WriteString("name", ExportedFlight.Printable(truth.Name));
        _json.WriteString("class", ExportedFlight.Printable(TargetClassNames.Name(truth.Class)));
        _json.WriteBoolean("found", truth.IsFound);
        BeginGeometry("Point");
        WritePosition(truth.Position);
        EndFeature();
    }

    // Properties are written between the two.
    private void BeginFeature(string kind)
    {
        _json.WriteStartObject();
        _json.WriteString("type", "Feature");
        _json.WriteStartObject("properties");
        _json.WriteString("kind", kind);
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

    private void WritePolygon(
        IReadOnlyList<GeodeticPosition> outline, IEnumerable<IReadOnlyList<GeodeticPosition>> holes)
    {
        _json.WriteStartArray();
        WritePositions(outline);
        foreach (IReadOnlyList<GeodeticPosition> hole in holes)
            WritePositions(hole);
        _json.WriteEndArray();
    }

    private void WritePositions(IEnumerable<GeodeticPosition> positions)
    {
        _json.WriteStartArray();
        foreach (GeodeticPosition position in positions)
            WritePosition(position);
        _json.WriteEndArray();
    }

    private void WritePosition(GeodeticPosition position)
    {
        _json.WriteStartArray();
        _json.WriteNumberValue(ExportedFlight.Degrees(position.Longitude));
        _json.WriteNumberValue(ExportedFlight.Degrees(position.Latitude));
        _json.WriteEndArray();
    }

    private void WriteArray(string name, IEnumerable<double> values, int decimals)
    {
        _json.WriteStartArray(name);
        foreach (double value in values)
        {
            if (Math.Abs(value) < 1e15)
                _json.WriteNumberValue((decimal)Math.Round(value, decimals));
            else
                _json.WriteNullValue();
        }

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
