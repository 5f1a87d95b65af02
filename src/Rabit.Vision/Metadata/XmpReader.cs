using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Xml;

namespace Rabit.Vision;

/// <summary>
/// Reads the properties of a drone out of XMP (ISO 16684-1): attributes or elements of the namespace of DJI. Their
/// numbers are written "+40.10" or "40.100000".
/// </summary>
internal static class XmpReader
{
    private const string Namespace = "http://www.dji.com/drone-dji/";
    public const double MaxMetres = 100_000;
    public const double MaxPixels = 1_000_000;
    public const double MaxDegrees = 360;
    private const int MaxReason = 200;

    public static void Read(string text, PhotoMetadata photo, List<string> faults)
    {
        var settings = new XmlReaderSettings
        {
            DtdProcessing = DtdProcessing.Prohibit,
            XmlResolver = null,
            ConformanceLevel = ConformanceLevel.Auto,
        };
        var found = new Dictionary<string, string>(StringComparer.Ordinal);
        try
        {
            using var reader = XmlReader.Create(new StringReader(text.TrimEnd('\0')), settings);
            ReadNodes(reader, found);
        }
        catch (XmlException e)
        {
            // It may name each element that has no end.
            faults.Add("XMP: " + (e.Message.Length > MaxReason ? e.Message.Remove(MaxReason) : e.Message));
        }

        Take(found, photo, faults);
    }

    // A text comes in parts where a comment or the like divides it; it ends where its element does, or another begins.
    private static void ReadNodes(XmlReader reader, Dictionary<string, string> found)
    {
        string? element = null;
        string text = string.Empty;
        while (reader.Read())
        {
            if (reader.NodeType is XmlNodeType.Text or XmlNodeType.CDATA && element is not null)
                text += reader.Value;
            if (reader.NodeType is not (XmlNodeType.Element or XmlNodeType.EndElement))
                continue;
            if (element is not null && text.Length > 0)
                Add(found, element, text);
            bool isBegin = reader.NodeType == XmlNodeType.Element;
            (element, text) = (isBegin && !reader.IsEmptyElement && IsDrone(reader) ? reader.LocalName : null, "");
            if (isBegin)
                AddAttributes(reader, found);
        }
    }

    private static void AddAttributes(XmlReader reader, Dictionary<string, string> found)
    {
        while (reader.MoveToNextAttribute())
        {
            if (IsDrone(reader))
                Add(found, reader.LocalName, reader.Value);
        }
    }

    private static bool IsDrone(XmlReader reader)
        => reader.NamespaceURI.StartsWith(Namespace, StringComparison.Ordinal);

    private static void Add(Dictionary<string, string> found, string name, string value)
    {
        if (!found.TryGetValue(name, out _))
            found[name] = value;
    }

    private static void Take(Dictionary<string, string> found, PhotoMetadata photo, List<string> faults)
    {
        double? Number(string name, double max)
        {
            if (!found.TryGetValue(name, out string? text))
                return null;
            if (double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
                && Math.Abs(value) <= max)
                return value;
            faults.Add($"XMP: {name} is no number of its range");
            return null;
        }

        photo.FocalLengthPixels = Number("CalibratedFocalLength", MaxPixels) is > 0 and { } focal ? focal : null;
        if (found.TryGetValue("DewarpData", out string? lens)
            && !(found.TryGetValue("DewarpFlag", out string? isCorrected) && isCorrected.Trim() == "1"))
        {
            photo.Lens = XmpLens.Read(lens);
            if (photo.Lens is null)
                faults.Add("XMP: DewarpData is not of its form");
        }

        photo.GimbalRollDegrees = Number("GimbalRollDegree", MaxDegrees);
        photo.GimbalPitchDegrees = Number("GimbalPitchDegree", MaxDegrees);
        photo.GimbalYawDegrees = Number("GimbalYawDegree", MaxDegrees);
        photo.FlightRollDegrees = Number("FlightRollDegree", MaxDegrees);
        photo.FlightPitchDegrees = Number("FlightPitchDegree", MaxDegrees);
        photo.FlightYawDegrees = Number("FlightYawDegree", MaxDegrees);
        photo.RelativeAltitudeMetres = Number("RelativeAltitude", MaxMetres);
        photo.AbsoluteAltitudeMetres = Number("AbsoluteAltitude", MaxMetres);

        // Of two spellings, and one with a mistake that some models have.
        double? latitude = Number("GpsLatitude", 90) ?? Number("GPSLatitude", 90);
        double? longitude =
            Number("GpsLongitude", 180) ?? Number("GPSLongitude", 180) ?? Number("GpsLongtitude", 180);
        if (photo.LatitudeDegrees is null && latitude is { } north && longitude is { } east
            && (north != 0 || east != 0))
            (photo.LatitudeDegrees, photo.LongitudeDegrees) = (north, east);
    }
}
