using System;
using System.Text.Json;

namespace Rabit.Uav.Reporting.Exports;

/// <summary>
/// Writes a collection of features of GeoJSON, RFC 7946: of each the kind and what more its properties are, then its
/// geometry. For one thread.
/// </summary>
/// <param name="json">Where it goes; the caller writes properties and coordinates to it.</param>
internal sealed class GeoJsonFeatures(Utf8JsonWriter json)
{
    private const int DegreeDecimals = 7;   // a centimetre

    public void BeginCollection()
    {
        json.WriteStartObject();
        json.WriteString("type", "FeatureCollection");
        json.WriteStartArray("features");
    }

    public void EndCollection()
    {
        json.WriteEndArray();
        json.WriteEndObject();
    }

    /// <summary>Begins a feature; its properties follow, and <see cref="BeginGeometry"/>.</summary>
    public void Begin(string kind)
    {
        json.WriteStartObject();
        json.WriteString("type", "Feature");
        json.WriteStartObject("properties");
        json.WriteString("kind", kind);
    }

    /// <summary>Ends the properties; the coordinates follow, and <see cref="End"/>.</summary>
    public void BeginGeometry(string type)
    {
        json.WriteEndObject();
        json.WriteStartObject("geometry");
        json.WriteString("type", type);
        json.WritePropertyName("coordinates");
    }

    public void End()
    {
        json.WriteEndObject();
        json.WriteEndObject();
    }

    /// <summary>Ends the properties and the feature, which is nowhere.</summary>
    public void EndWithoutGeometry()
    {
        json.WriteEndObject();
        json.WriteNull("geometry");
        json.WriteEndObject();
    }

    /// <summary>A place, longitude first.</summary>
    public void WritePosition(double longitudeDegrees, double latitudeDegrees)
    {
        json.WriteStartArray();
        json.WriteNumberValue((decimal)Math.Round(longitudeDegrees, DegreeDecimals));
        json.WriteNumberValue((decimal)Math.Round(latitudeDegrees, DegreeDecimals));
        json.WriteEndArray();
    }

    /// <summary>A property; null where it is no number, which JSON does not have.</summary>
    public void WriteNumber(string name, double value, int decimals)
    {
        if (Math.Abs(value) < 1e15)
            json.WriteNumber(name, (decimal)Math.Round(value, decimals));
        else
            json.WriteNull(name);
    }
}
