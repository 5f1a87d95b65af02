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
    private readonly GeoJsonFeatures _features;
    private readonly ExportedFlight _flight;

    private GeoJsonExport(Utf8JsonWriter json, ExportedFlight flight)
        => (_json, _features, _flight) = (json, new GeoJsonFeatures(json), flight);

    public static void Write(Stream output, FlightSummary summary)
    {
        using var json = new Utf8JsonWriter(output);
        new GeoJsonExport(json, new ExportedFlight(summary)).Write();
    }

    private void Write()
    {
        _features.BeginCollection();
        WritePlan();
        WriteSeenGround();
        WritePath();
        foreach (TargetTrack target in _flight.Targets)
            WriteTarget(target);
        foreach (TargetScore truth in _flight.Truth)
            WriteTruth(truth);
        _features.EndCollection();
    }

    private void WritePlan()
    {
        if (_flight.Plan is not { } plan)
            return;
        _features.Begin("home");
        _json.WriteString("name", _flight.Name);
        _features.WriteNumber("altitudeAmslMetres", plan.Home.AltitudeAmslMetres, 2);
        _features.BeginGeometry("Point");
        WritePosition(plan.Home);
        _features.End();
        foreach ((string kind, IReadOnlyList<GeodeticPosition> corners) in _flight.Polygons())
        {
            _features.Begin(kind);
            _features.BeginGeometry("Polygon");
            WritePolygon(ExportedFlight.Ring(corners), []);
            _features.End();
        }

        int number = 0;
        foreach ((GeodeticPosition start, GeodeticPosition end) in _flight.Lanes())
        {
            _features.Begin("lane");
            _json.WriteNumber("number", ++number);
            _features.BeginGeometry("LineString");
            WritePositions([start, end]);
            _features.End();
        }
    }

    private void WriteSeenGround()
    {
        if (_flight.SeenGround() is not { Count: > 0 } patches)
            return;
        _features.Begin("coverage");
        _features.WriteNumber("coveragePercent", _flight.CoveragePercent, 2);
        _features.BeginGeometry("MultiPolygon");
        _json.WriteStartArray();
        foreach (SeenPatch patch in patches)
            WritePolygon(
                ExportedFlight.Ring(patch.Outline),
                patch.Holes.Select(h => ExportedFlight.Ring(h, isHole: true)));
        _json.WriteEndArray();
        _features.End();
    }

    // A line has two places at least. One entry of each array for each place.
    private void WritePath()
    {
        IReadOnlyList<FlightSample> path = _flight.Path;
        if (path.Count < 2)
            return;
        _features.Begin("path");
        WriteArray("timeSeconds", path.Select(s => s.Time.TotalSeconds), 3);
        WriteArray("altitudeAmslMetres", path.Select(s => s.Position.AltitudeAmslMetres), 2);
        WriteArray("heightAboveHomeMetres", path.Select(s => s.HeightAboveHomeMetres), 2);
        _features.BeginGeometry("LineString");
        WritePositions(path.Select(s => s.Position));
        _features.End();
    }

    private void WriteTarget(TargetTrack target)
    {
        _features.Begin("target");
        WriteTargetFacts(target);
        _features.WriteNumber("ellipse95HalfMajorAxisMetres", target.Covariance.HalfMajorAxis95Metres, 3);
        _features.WriteNumber("ellipse95HalfMinorAxisMetres", target.Covariance.HalfMinorAxis95Metres, 3);
        _features.WriteNumber("ellipseMajorAxisDegrees", target.Covariance.MajorAxis.Degrees, 2);
        _json.WriteNumber("reports", target.Reports);
        if (target.Bearing is { } bearing)
        {
            _features.WriteNumber("bearingDegrees", bearing.Angle.Degrees, 2);
            _features.WriteNumber("bearingDeviationDegrees", bearing.TotalSigma.Degrees, 2);
            _json.WriteString("bearingSymmetry", bearing.Symmetry.ToString());
        }

        _features.WriteNumber("firstSeenSeconds", target.FirstSeen.TotalSeconds, 3);
        _features.WriteNumber("lastSeenSeconds", target.LastSeen.TotalSeconds, 3);
        _features.BeginGeometry("Point");
        WritePosition(target.Position);
        _features.End();
        if (ExportedFlight.Ellipse(target) is not { Count: > 0 } ellipse)
            return;
        _features.Begin("ellipse95");
        WriteTargetFacts(target);
        _features.BeginGeometry("Polygon");
        WritePolygon(ExportedFlight.Ring(ellipse), []);
        _features.End();
    }

    private void WriteTargetFacts(TargetTrack target)
    {
        _json.WriteNumber("number", target.Id);
        _json.WriteString("class", ExportedFlight.Printable(TargetClassNames.Name(target.Class)));
        _json.WriteString("state", ExportedFlight.StateOf(target));
    }

    private void WriteTruth(TargetScore truth)
    {
        _features.Begin("truth");
        _json.WriteString("name", ExportedFlight.Printable(truth.Name));
        _json.WriteString("class", ExportedFlight.Printable(TargetClassNames.Name(truth.Class)));
        _json.WriteBoolean("found", truth.IsFound);
        _json.WriteBoolean("rejected", truth.IsRejected);
        _features.BeginGeometry("Point");
        WritePosition(truth.Position);
        _features.End();
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
        => _features.WritePosition(position.Longitude.Degrees, position.Latitude.Degrees);

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
}
