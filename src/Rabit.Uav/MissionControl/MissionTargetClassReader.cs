using System;
using System.Collections.Immutable;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Uav.Json;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace Rabit.Uav.MissionControl;

/// <summary>Reads the classes of targets that a mission file declares, by their names.</summary>
internal static class MissionTargetClassReader
{
    // Also the sizes that a class has if the file says none.
    private static readonly TargetClass Default = new("default");

    // The first one where the file says none.
    private static readonly TargetShape[] Shapes =
        [TargetShape.Any, TargetShape.Rectangle, TargetShape.Circle, TargetShape.Cross, TargetShape.Triangle];

    /// <param name="fields">Of the mission.</param>
    /// <param name="folder">Where files are that it names without a folder.</param>
    public static ImmutableArray<TargetClass> Read(JsonFields fields, string folder)
    {
        var classes = ImmutableArray.CreateBuilder<TargetClass>();
        JsonFields given = fields.Object("targetClasses");
        foreach (string name in given.Names)
        {
            if (TargetClassName.TryParse(name, out _))
                classes.Add(Read(given.Object(name), name, folder));
            else
                given.Blame(
                    name, given.Any(name)!.Value, "must be by the name of a target class: " + TargetClassName.Rule);
        }

        return classes.ToImmutable();
    }

    private static TargetClass Read(JsonFields one, string name, string folder)
    {
        var read = new TargetClass(name)
        {
            Colour = ReadColour(one, "colour"),
            SecondColour = ReadColour(one, "secondColour"),
            Marker = ReadMarker(one),
            Shape = ReadShape(one),
            Template = ReadTemplate(one, folder),
            HotSpot = ReadHotSpot(one),
            MinSideMetres = one.Number("minSideMetres") ?? Default.MinSideMetres,
            MaxSideMetres = one.Number("maxSideMetres") ?? Default.MaxSideMetres,
            MinAspect = one.Number("minAspect") ?? Default.MinAspect,
            MaxAspect = one.Number("maxAspect") ?? Default.MaxAspect,
            MinColourShare = one.Number("minColourShare") ?? Default.MinColourShare,
        };
        one.RefuseOthers();
        return read;
    }

    private static ColourRange? ReadColour(JsonFields one, string key)
    {
        if (one.Any(key) is not { } given)
            return null;
        string text = given.ValueKind == JsonValueKind.String ? given.GetString()! : string.Empty;
        string digits = text.TrimStart('#');
        if (text.Length == 7 && digits.Length == 6
            && int.TryParse(digits, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out int rgb))
            return new ColourRange((byte)(rgb >> 16), (byte)(rgb >> 8), (byte)rgb);
        one.Blame(key, given, "must be sRGB in hexadecimal digits, \"#rrggbb\"");
        return null;
    }

    private static TargetShape ReadShape(JsonFields one)
    {
        string? name = one.Choice("shape", [.. Shapes.Select(s => s.ToString())]);
        return Shapes.FirstOrDefault(s => string.Equals(s.ToString(), name, StringComparison.Ordinal));
    }

    private static TargetMarker? ReadMarker(JsonFields one)
    {
        if (!one.Has("marker"))
            return null;
        JsonFields marker = one.RequiredObject("marker");
        string? family = marker.Choice("family", nameof(MarkerFamily.ArUco4x4), nameof(MarkerFamily.AprilTag36h11));
        if (family is null)
            marker.Missing("family");
        int? id = marker.Has("id") ? marker.RequiredWholeNumber("id") : null;
        marker.RefuseOthers();
        return new TargetMarker(
            family == nameof(MarkerFamily.ArUco4x4) ? MarkerFamily.ArUco4x4 : MarkerFamily.AprilTag36h11, id);
    }

    private static HotSpotTarget? ReadHotSpot(JsonFields one)
    {
        if (!one.Has("hotSpot"))
            return null;
        var defaults = new HotSpotTarget();
        JsonFields spot = one.RequiredObject("hotSpot");
        var read = new HotSpotTarget
        {
            MinContrastCounts = spot.Number("minContrastCounts") ?? defaults.MinContrastCounts,
            MinSigmas = spot.Number("minSigmas") ?? defaults.MinSigmas,
        };
        spot.RefuseOthers();
        return read;
    }

    private static ObjectTemplate? ReadTemplate(JsonFields one, string folder)
    {
        if (one.Text("template") is not { } file)
            return null;
        try
        {
            return ObjectTemplate.Load(Path.Combine(folder, file));
        }
        catch (Exception e) when (e is PictureException or ArgumentException)
        {
            one.Blame(
                "template", one.Any("template")!.Value, "must be a template that rabit train wrote; " + e.Message);
            return null;
        }
    }
}
