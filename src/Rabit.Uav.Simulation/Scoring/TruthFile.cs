using System;
using System.Collections.Generic;
using System.IO;
using System.Text.Json;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>
/// Truth as JSON, docs/uavconsole-summary.md:
/// format and version, home (latitudeDegrees, longitudeDegrees), and targets (name, class, latitudeDegrees,
/// longitudeDegrees).
/// Other fields are ignored when it is read.
/// </summary>
/// <example>
/// <code>
/// TargetTruth truth = TruthFile.Parse(File.ReadAllText("truth.json"));
/// using FileStream copy = File.Create("copy.json");
/// TruthFile.Write(copy, truth);
/// </code>
/// </example>
public static class TruthFile
{
    internal const string Format = "rabit-truth";
    internal const int Version = 1;

    /// <summary>Reads the truth.</summary>
    /// <param name="json">The text of the file.</param>
    /// <exception cref="FormatException">
    /// It is not such a file; the text names all that is wrong, on one line.
    /// </exception>
    public static TargetTruth Parse(string json)
    {
        try
        {
            using JsonDocument document = JsonDocument.Parse(json);
            var faults = new List<string>();
            TargetTruth truth = new TruthParser(faults).Parse(document.RootElement);
            return faults.Count == 0 ? truth : throw new FormatException(string.Join("; ", faults) + ".");
        }
        catch (JsonException e)
        {
            throw new FormatException($"it is not JSON (line {e.LineNumber + 1}).", e);
        }
    }

    /// <summary>Writes the truth.</summary>
    /// <param name="stream">Where to, UTF-8; it is not closed.</param>
    /// <param name="truth">What to write.</param>
    public static void Write(Stream stream, TargetTruth truth)
    {
        if (truth is null)
            throw new ArgumentNullException(nameof(truth));
        using Utf8JsonWriter json = Begin(stream, truth);
        json.WriteEndObject();
    }

    /// <summary>
    /// Writes the truth of a simulated world: its targets, the seed, the wind, and what the vehicle has done so far.
    /// </summary>
    /// <param name="stream">Where to, UTF-8; it is not closed.</param>
    /// <param name="world">What to write.</param>
    public static void Write(Stream stream, SimulatedWorld world)
    {
        if (world is null)
            throw new ArgumentNullException(nameof(world));
        using Utf8JsonWriter json = Begin(stream, TargetTruth.Of(world));
        json.WriteNumber("seed", world.Options.Seed);
        json.WriteNumber("groundAltitudeAmslMetres", world.Options.Home.AltitudeAmslMetres);
        json.WriteNumber("windMetresPerSecond", world.Options.WindMetresPerSecond);
        SimulatedTruth truth = world.Truth;
        if (truth.HasFlown)
            WriteFlight(json, truth);
        else
            json.WriteNull("flight");
        json.WriteEndObject();
    }

    private static Utf8JsonWriter Begin(Stream stream, TargetTruth truth)
    {
        var json = new Utf8JsonWriter(
            stream ?? throw new ArgumentNullException(nameof(stream)), new JsonWriterOptions { Indented = true });
        json.WriteStartObject();
        json.WriteString("format", Format);
        json.WriteNumber("version", Version);
        json.WriteStartObject("home");
        WritePosition(json, truth.Home);
        json.WriteEndObject();
        json.WriteStartArray("targets");
        foreach (TruthTarget target in truth.Targets)
        {
            if (target.Way is not null)
                throw new ArgumentException(
                    $"'{target.Name}' moves: a truth file says where targets stand.", nameof(truth));
            json.WriteStartObject();
            json.WriteString("name", target.Name);
            json.WriteString("class", Reporting.TargetClassNames.Name(target.Class));
            WritePosition(json, target.Position);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        return json;
    }

    private static void WriteFlight(Utf8JsonWriter json, SimulatedTruth truth)
    {
        json.WriteStartObject("flight");
        json.WriteBoolean("hasCrashed", truth.HasCrashed);
        json.WriteBoolean("isAirborne", truth.IsAirborne);
        json.WriteBoolean("isArmed", truth.IsArmed);
        if (truth.Landing is { } landing)
        {
            json.WriteStartObject("landing");
            WritePose(json, landing);
        }
        else
        {
            json.WriteNull("landing");
        }

        json.WriteNumber("batteryRemaining", truth.BatteryRemaining);
        json.WriteNumber("airtimeSeconds", truth.Airtime.ExactSeconds);
        json.WriteNumber("flownMetres", truth.FlownMetres);
        json.WriteNumber("maxHeightMetres", truth.MaxHeightMetres);
        json.WriteNumber("maxSpeedMetresPerSecond", truth.MaxSpeedMetresPerSecond);
        json.WriteNumber("maxDistanceMetres", truth.MaxDistanceMetres);
        json.WriteStartArray("path");
        foreach (TruePose pose in truth.Path)
        {
            json.WriteStartObject();
            WritePose(json, pose);
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    // Ends the object that was begun.
    private static void WritePose(Utf8JsonWriter json, in TruePose pose)
    {
        json.WriteNumber("timeSeconds", Math.Round(pose.Time.ExactSeconds, 3));
        json.WriteNumber("northMetres", Math.Round(pose.Position.North, 3));
        json.WriteNumber("eastMetres", Math.Round(pose.Position.East, 3));
        json.WriteNumber("heightMetres", Math.Round(-pose.Position.Down, 3) + 0.0);
        json.WriteNumber("rollDegrees", Degrees(pose.Attitude.Roll.Radians, 2));
        json.WriteNumber("pitchDegrees", Degrees(pose.Attitude.Pitch.Radians, 2));
        json.WriteNumber("yawDegrees", Degrees(pose.Attitude.Yaw.Radians, 2));
        json.WriteEndObject();
    }

    private static void WritePosition(Utf8JsonWriter json, GeodeticPosition position)
    {
        // Nine decimals: a tenth of a millimetre.
        json.WriteNumber("latitudeDegrees", Degrees(position.Latitude.Radians, 9));
        json.WriteNumber("longitudeDegrees", Degrees(position.Longitude.Radians, 9));
    }

    private static double Degrees(double radians, int decimals)
        => Math.Round(Angle.FromRadians(radians).Degrees, decimals);
}
