using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace Rabit.Tool.Geolocation;

/// <summary>What the command line asks for.</summary>
internal sealed class GeolocateOptions
{
    /// <summary>The camera's file, or a photo.</summary>
    public string Camera { get; set; } = "";

    public string? Request { get; set; }

    public string? Telemetry { get; set; }

    public string? Terrain { get; set; }

    public double? TimeSeconds { get; set; }

    /// <summary>Instead of those of the request; none where the request has them.</summary>
    public IReadOnlyList<(double Column, double Row)> Pixels { get; set; } = [];

    public bool IsJson { get; set; }

    /// <summary>The file for the places as GeoJSON.</summary>
    public string? GeoJson { get; set; }

    /// <summary>Whether the first file is a photo, which describes its camera itself.</summary>
    public bool IsPhoto => Path.GetExtension(Camera).ToUpperInvariant() is ".JPG" or ".JPEG" or ".PNG";

    /// <summary>Whether the pixels of the photo were turned by half a turn after it was taken.</summary>
    public bool IsTurned { get; set; }

    /// <summary>What the options say of a photo, by their names without dashes.</summary>
    public IDictionary<string, double> OfPhoto { get; } = new Dictionary<string, double>(StringComparer.Ordinal);

    /// <summary>What makes no sense together.</summary>
    /// <returns>A sentence; null where all does.</returns>
    public string? FindFault()
    {
        if (Telemetry is null != TimeSeconds is null)
            return "--telemetry and --time go together.";
        if (!IsPhoto && (IsTurned || OfPhoto.Count > 0))
            return $"--{(IsTurned ? "turned" : OfPhoto.Keys.First())} is for a photo (.jpg, .jpeg, .png), which {Camera} is "
                + "not.";
        if (IsPhoto && (Request ?? Telemetry) is { } other)
            return $"{Camera} is a photo, which needs no {other}.";
        if (FindFaultOfPhoto() is { } fault)
            return fault;
        if (GeoJson is not null && Array.Find([Camera, Request, Telemetry, Terrain], IsOutput) is { } read)
            return $"--geojson would overwrite {read}, which is read.";
        return null;
    }

    private string? FindFaultOfPhoto()
    {
        bool hasGround = OfPhoto.ContainsKey("ground-altitude");
        if (hasGround && OfPhoto.ContainsKey("height"))
            return "--height and --ground-altitude exclude each other: both say where the ground is.";
        if (Terrain is not null && (hasGround || OfPhoto.ContainsKey("height")))
            return $"--{(hasGround ? "ground-altitude" : "height")} and --terrain exclude each other: both say where the "
                + "ground is.";
        if (OfPhoto.ContainsKey("focal-length-35mm") && OfPhoto.ContainsKey("sensor-width"))
            return "--focal-length-35mm and --sensor-width exclude each other: both say what the focal length is.";
        return OfPhoto.ContainsKey("focal-length") && !OfPhoto.ContainsKey("sensor-width")
            ? "--focal-length needs --sensor-width."
            : null;
    }

    private bool IsOutput(string? input)
        => !string.IsNullOrEmpty(input) && !string.IsNullOrEmpty(GeoJson)
            && Path.GetFullPath(input).Equals(Path.GetFullPath(GeoJson), StringComparison.Ordinal);
}
