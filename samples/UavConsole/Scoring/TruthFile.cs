using System;
using System.Collections.Generic;
using System.IO;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>
/// Truth as a JSON file:
/// <c>{"format":"rabit-truth","version":1,"home":{"lat_deg","lon_deg"},"targets":[{"name","color","lat_deg","lon_deg"}]}</c>.
/// </summary>
internal static class TruthFile
{
    private const string Format = "rabit-truth";
    private const int Version = 1;

    /// <exception cref="ArgumentException">It cannot be read or is not such a file; the text says what is wrong, on one line.</exception>
    public static Truth Read(string path)
    {
        try
        {
            return Parse(File.ReadAllText(path), path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            throw new ArgumentException($"--truth {path} cannot be read: {e.Message}", nameof(path), e);
        }
    }

    /// <param name="json">The text of the file.</param>
    /// <param name="name">Its name, for errors.</param>
    /// <exception cref="ArgumentException">It is not such a file; the text names all that is wrong, on one line.</exception>
    public static Truth Parse(string json, string name)
    {
        try
        {
            using JsonDocument document = JsonDocument.Parse(json);
            var faults = new List<string>();
            Truth truth = Parse(document.RootElement, faults);
            return faults.Count == 0 ? truth : throw Bad(name, string.Join("; ", faults), null);
        }
        catch (JsonException e)
        {
            throw Bad(name, $"it is no JSON (line {e.LineNumber + 1})", e);
        }
    }

    /// <summary>Writes it: what <see cref="Parse(string, string)"/> reads.</summary>
    public static void Write(Stream stream, Truth truth)
    {
        using var json = new Utf8JsonWriter(stream, new JsonWriterOptions { Indented = true });
        json.WriteStartObject();
        json.WriteString("format", Format);
        json.WriteNumber("version", Version);
        json.WriteStartObject("home");
        WritePosition(json, truth.Home);
        json.WriteEndObject();
        json.WriteStartArray("targets");
        foreach (TruthTarget target in truth.Targets)
        {
            json.WriteStartObject();
            json.WriteString("name", target.Name);
            json.WriteString("color", Colours.Name(target.Class));
            WritePosition(json, target.Position);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static Truth Parse(JsonElement root, List<string> faults)
    {
        if (root.ValueKind != JsonValueKind.Object || StringOf(root, "format") != Format)
        {
            faults.Add($"it does not say \"format\": \"{Format}\"");
            return new Truth(default, []);
        }

        if (!root.TryGetProperty("version", out JsonElement version) || version.ValueKind != JsonValueKind.Number || !version.TryGetInt32(out int number) || number != Version)
            faults.Add($"its version is not {Version}");
        GeodeticPosition home = default;
        if (root.TryGetProperty("home", out JsonElement place))
            home = PositionOf(place, "home", faults);
        else
            faults.Add("home is missing");

        var targets = new List<TruthTarget>();
        if (!root.TryGetProperty("targets", out JsonElement list) || list.ValueKind != JsonValueKind.Array)
            faults.Add("targets is not a list");
        else
            ParseTargets(list, targets, faults);
        return new Truth(home, targets);
    }

    private static void ParseTargets(JsonElement list, List<TruthTarget> targets, List<string> faults)
    {
        foreach (JsonElement element in list.EnumerateArray())
        {
            string where = $"targets[{targets.Count}]";
            if (element.ValueKind == JsonValueKind.Object && StringOf(element, "color") is { } text)
            {
                if (!TargetClassName.TryParse(text, out TargetClassName targetClass))
                    faults.Add($"{where}: '{text}' is no name of a target class (1 to 16 ASCII characters)");
                targets.Add(new TruthTarget(StringOf(element, "name") ?? where, targetClass, PositionOf(element, where, faults)));
            }
            else
            {
                faults.Add($"{where} has no color");
                targets.Add(new TruthTarget(where, TargetClassName.None, default));
            }
        }
    }

    private static GeodeticPosition PositionOf(JsonElement element, string where, List<string> faults)
        => GeodeticPosition.FromDegrees(AngleOf(element, "lat_deg", 90, where, faults), AngleOf(element, "lon_deg", 180, where, faults), 0);

    private static double AngleOf(JsonElement element, string name, double limit, string where, List<string> faults)
    {
        if (element.ValueKind == JsonValueKind.Object && element.TryGetProperty(name, out JsonElement value)
            && value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out double degrees) && Math.Abs(degrees) <= limit)
            return degrees;
        faults.Add($"{where}: {name} is not a number from {-limit} to {limit}");
        return 0;
    }

    private static string? StringOf(JsonElement element, string name)
        => element.TryGetProperty(name, out JsonElement value) && value.ValueKind == JsonValueKind.String ? value.GetString() : null;

    private static void WritePosition(Utf8JsonWriter json, GeodeticPosition position)
    {
        // Nine decimals: a tenth of a millimetre.
        json.WriteNumber("lat_deg", Math.Round(position.Latitude.Degrees, 9));
        json.WriteNumber("lon_deg", Math.Round(position.Longitude.Degrees, 9));
    }

    private static ArgumentException Bad(string name, string why, Exception? inner) => new($"--truth {name}: {why}.", nameof(name), inner);
}
