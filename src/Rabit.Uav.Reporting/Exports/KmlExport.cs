using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Xml;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting.Exports;

/// <summary>KML 2.2 (OGC 07-147r2): longitude, latitude, altitude above mean sea level.</summary>
internal sealed class KmlExport
{
    private const string Namespace = "http://www.opengis.net/kml/2.2";

    // Colours are alpha, blue, green, red.
    private static readonly (string Kind, string Line, string Width, string? Fill)[] Styles =
    [
        ("area", "ffffffff", "2", "00ffffff"),
        ("fence", "ff1e26b3", "2", "00ffffff"),
        ("keep-out", "ff1e26b3", "2", "401e26b3"),
        ("lane", "ffb8a394", "1", null),
        ("coverage", "0096a014", "1", "6096a014"),
        ("path", "ffeb6325", "3", null),
        ("ellipse95", "ff00ffff", "2", "3000ffff"),
    ];

    private readonly XmlWriter _xml;
    private readonly ExportedFlight _flight;

    private KmlExport(XmlWriter xml, ExportedFlight flight) => (_xml, _flight) = (xml, flight);

    public static void Write(Stream output, FlightSummary summary)
    {
        var settings = new XmlWriterSettings
        {
            Encoding = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false),
            Indent = true,
        };
        using var xml = XmlWriter.Create(output, settings);
        new KmlExport(xml, new ExportedFlight(summary)).Write();
    }

    private void Write()
    {
        _xml.WriteStartDocument();
        _xml.WriteStartElement("kml", Namespace);
        _xml.WriteStartElement("Document", Namespace);
        Element("name", _flight.Name);
        foreach ((string kind, string line, string width, string? fill) in Styles)
            WriteStyle(kind, line, width, fill);
        WritePlan();
        WriteSeenGround();
        WritePath();
        foreach (TargetTrack target in _flight.Targets)
            WriteTarget(target);
        foreach (TargetScore truth in _flight.Truth)
        {
            BeginPlacemark($"truth: {truth.Name}", null);
            WritePoint(truth.Position);
            _xml.WriteEndElement();
        }

        _xml.WriteEndElement();
        _xml.WriteEndElement();
        _xml.WriteEndDocument();
    }

    private void WriteStyle(string kind, string line, string width, string? fill)
    {
        _xml.WriteStartElement("Style", Namespace);
        _xml.WriteAttributeString("id", kind);
        _xml.WriteStartElement("LineStyle", Namespace);
        Element("color", line);
        Element("width", width);
        _xml.WriteEndElement();
        if (fill is not null)
        {
            _xml.WriteStartElement("PolyStyle", Namespace);
            Element("color", fill);
            _xml.WriteEndElement();
        }

        _xml.WriteEndElement();
    }

    private void WritePlan()
    {
        if (_flight.Plan is not { } plan)
            return;
        BeginPlacemark("home", null);
        WritePoint(plan.Home);
        _xml.WriteEndElement();
        foreach ((string kind, IReadOnlyList<GeodeticPosition> corners) in _flight.Polygons())
        {
            BeginPlacemark(kind, kind);
            WritePolygon(ExportedFlight.Ring(corners), []);
            _xml.WriteEndElement();
        }

        int number = 0;
        foreach ((GeodeticPosition start, GeodeticPosition end) in _flight.Lanes())
        {
            BeginPlacemark("lane " + FlightText.Number(++number), "lane");
            WriteLine([start, end]);
            _xml.WriteEndElement();
        }
    }

    private void WriteSeenGround()
    {
        if (_flight.SeenGround() is not { Count: > 0 } patches)
            return;
        BeginPlacemark("coverage", "coverage");
        _xml.WriteStartElement("MultiGeometry", Namespace);
        foreach (SeenPatch patch in patches)
            WritePolygon(
                ExportedFlight.Ring(patch.Outline),
                patch.Holes.Select(h => ExportedFlight.Ring(h, isHole: true)));
        _xml.WriteEndElement();
        _xml.WriteEndElement();
    }

    private void WritePath()
    {
        if (_flight.Path.Count < 2)
            return;
        BeginPlacemark("path", "path");
        WriteLine(_flight.Path.Select(s => s.Position));
        _xml.WriteEndElement();
    }

    private void WriteTarget(TargetTrack target)
    {
        string name = $"{FlightText.Number(target.Id)} {TargetClassNames.Name(target.Class)}";
        BeginPlacemark(name, null, $"{ExportedFlight.StateOf(target)}, {FlightText.Number(target.Reports)} reports, "
            + $"95 % ellipse {FlightText.Number(target.Covariance.HalfMajorAxis95Metres, "0.0")} x "
            + $"{FlightText.Number(target.Covariance.HalfMinorAxis95Metres, "0.0")} m");
        WritePoint(target.Position);
        _xml.WriteEndElement();
        if (ExportedFlight.Ellipse(target) is not { Count: > 0 } ellipse)
            return;
        BeginPlacemark(name + ", 95 % ellipse", "ellipse95");
        WritePolygon(ExportedFlight.Ring(ellipse), []);
        _xml.WriteEndElement();
    }

    private void BeginPlacemark(string name, string? style, string? description = null)
    {
        _xml.WriteStartElement("Placemark", Namespace);
        Element("name", name);
        if (description is not null)
            Element("description", description);
        if (style is not null)
            Element("styleUrl", "#" + style);
    }

    private void WritePoint(GeodeticPosition position)
    {
        _xml.WriteStartElement("Point", Namespace);
        Element("coordinates", Coordinates([position], withAltitude: false));
        _xml.WriteEndElement();
    }

    private void WriteLine(IEnumerable<GeodeticPosition> positions)
    {
        _xml.WriteStartElement("LineString", Namespace);
        Element("altitudeMode", "absolute");
        Element("coordinates", Coordinates(positions, withAltitude: true));
        _xml.WriteEndElement();
    }

    private void WritePolygon(
        IReadOnlyList<GeodeticPosition> outline, IEnumerable<IReadOnlyList<GeodeticPosition>> holes)
    {
        _xml.WriteStartElement("Polygon", Namespace);
        WriteRing("outerBoundaryIs", outline);
        foreach (IReadOnlyList<GeodeticPosition> hole in holes)
            WriteRing("innerBoundaryIs", hole);
        _xml.WriteEndElement();
    }

    private void WriteRing(string boundary, IReadOnlyList<GeodeticPosition> ring)
    {
        _xml.WriteStartElement(boundary, Namespace);
        _xml.WriteStartElement("LinearRing", Namespace);
        Element("coordinates", Coordinates(ring, withAltitude: false));
        _xml.WriteEndElement();
        _xml.WriteEndElement();
    }

    private void Element(string name, string text)
        => _xml.WriteElementString(name, Namespace, ExportedFlight.Printable(text));

    private static string Coordinates(IEnumerable<GeodeticPosition> positions, bool withAltitude)
        => string.Join(" ", positions.Select(p => FlightText.Number(p.Longitude.Degrees, "0.0000000") + ","
            + FlightText.Number(p.Latitude.Degrees, "0.0000000")
            + (withAltitude ? "," + FlightText.Number(p.AltitudeAmslMetres, "0.00") : string.Empty)));
}
