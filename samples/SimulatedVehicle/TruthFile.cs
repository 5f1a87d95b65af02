using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.Simulation;

namespace SimulatedVehicle;

/// <summary>
/// The truth as JSON (docs/concepts/simulation.md): where the targets are, at the start, so that whoever flies can be scored; at the end again,
/// with what the vehicle did. Metres in a frame north, east, down with its origin at home; degrees for places and attitude.
/// </summary>
internal sealed class TruthFile : IDisposable
{
    private static readonly JsonSerializerOptions Format = new() { PropertyNamingPolicy = JsonNamingPolicy.CamelCase, WriteIndented = true };

    private readonly FileStream _file;

    private TruthFile(FileStream file) => _file = file;

    // What was there before stays until there is something to put in its place.
    public static TruthFile? Open(string? path)
        => path is null ? null : new TruthFile(new FileStream(path, FileMode.OpenOrCreate, FileAccess.Write, FileShare.Read));

    /// <summary>Writes all that is known, in place of what was written before.</summary>
    public void Write(SimulatedWorld world, SimulationOptions options)
    {
        SimulatedTruth truth = world.Truth;
        var document = new Dictionary<string, object?>(StringComparer.Ordinal)
        {
            ["format"] = "rabit-truth",
            ["version"] = 1,
            ["seed"] = options.Seed,
            ["home"] = Place(options.Home),
            ["groundAltitudeAmslMetres"] = options.Home.AltitudeAmslMetres,
            ["targets"] = world.Targets.Select(t => Target(t, world.PositionOf(t.NorthMetres, t.EastMetres))).ToArray(),
            ["windMetresPerSecond"] = options.WindMetresPerSecond,
            ["flight"] = truth.HasFlown ? Flight(truth) : null,
        };
        _file.SetLength(0);
        JsonSerializer.Serialize(_file, document, Format);
        _file.Flush();
    }

    public void Dispose() => _file.Dispose();

    private static object Flight(SimulatedTruth truth) => new
    {
        truth.HasCrashed,
        truth.IsAirborne,
        truth.IsArmed,
        Landing = truth.Landing is { } landing ? Point(landing) : null,
        truth.BatteryRemaining,
        AirtimeSeconds = truth.Airtime.TotalSeconds,
        truth.FlownMetres,
        truth.MaxHeightMetres,
        truth.MaxSpeedMetresPerSecond,
        truth.MaxDistanceMetres,
        Path = truth.Path.Select(Point).ToArray(),
    };

    private static Dictionary<string, object> Target(SimulatedTarget target, GeodeticPosition place)
    {
        Dictionary<string, object> described = Place(place);
        described["name"] = target.Name;
        described["color"] = target.Class.ToString();
        return described;
    }

    // Nine decimals: a tenth of a millimetre.
    private static Dictionary<string, object> Place(GeodeticPosition place) => new(StringComparer.Ordinal)
    {
        ["lat_deg"] = Math.Round(place.Latitude.Degrees, 9),
        ["lon_deg"] = Math.Round(place.Longitude.Degrees, 9),
    };

    private static object Point(TruePose pose) => new
    {
        Seconds = Math.Round(pose.Time.TotalSeconds, 3),
        North = Math.Round(pose.North, 3),
        East = Math.Round(pose.East, 3),
        Height = Math.Round(-pose.Down, 3) + 0.0,
        Roll = Math.Round(pose.Roll / Angle.RadiansPerDegree, 2),
        Pitch = Math.Round(pose.Pitch / Angle.RadiansPerDegree, 2),
        Yaw = Math.Round(pose.Yaw / Angle.RadiansPerDegree, 2),
    };
}
