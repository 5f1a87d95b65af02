using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation.Tests.Px4;

/// <summary>What happened in a recorded flight of the real PX4 (tests/data/autopilots).</summary>
internal sealed class Px4Recording
{
    private Px4Recording(JsonElement root)
    {
        Root = root;
        Actions = Items("actions");
        JsonElement home = root.GetProperty("home");
        Home = GeodeticPosition.FromDegrees(
            home.GetProperty("lat").GetDouble(), home.GetProperty("lon").GetDouble(),
            home.GetProperty("alt_m").GetDouble());
    }

    public JsonElement Root { get; }

    public GeodeticPosition Home { get; }

    public double Duration => Root.GetProperty("duration_s").GetDouble();

    public IReadOnlyList<JsonElement> Actions { get; }

    /// <summary>Parameters and when they were set.</summary>
    public IEnumerable<(double Time, string Name, double Value)> Parameters => Items("parameters_set")
        .Select(p => (TimeOf(p), p.GetProperty("name").GetString()!, p.GetProperty("value").GetDouble()));

    /// <summary>Mode, base mode and status.</summary>
    public IEnumerable<(double Time, string State)> Modes => Items("mode_reports").Select(m => (
        TimeOf(m), $"{Text(m, "mode")} {Text(m, "base_mode")} {Text(m, "system_status")}"));

    public IEnumerable<(double Time, string Name)> LandedStates
        => Items("landed_states").Select(s => (TimeOf(s), s.GetProperty("name").GetString()!));

    public IEnumerable<(double Time, uint Id, string Arguments)> Events => Items("events")
        .GroupBy(e => e.GetProperty("sequence").GetInt32()).Select(g => g.First()).Select(e => (
        TimeOf(e), e.GetProperty("id").GetUInt32(), e.GetProperty("arguments").GetString()!));

    public IEnumerable<string> Texts
        => Items("gcs_statustext").Where(t => TimeOf(t) > 0).Select(t => t.GetProperty("text").GetString()!.Trim());

    /// <summary>When something was done to the vehicle: what failsafes count from.</summary>
    public IEnumerable<double> Causes
        => Actions.Select(TimeOf).Concat(Parameters.Select(p => p.Time)).Where(t => t >= 0);

    /// <summary>When a mode was commanded, or a failsafe began a return or a landing.</summary>
    public IEnumerable<double> ModeChanges
    {
        get
        {
            const uint ReturnActivated = 18121339;
            const uint Failsafe = 26528394;
            return Actions.Where(a => a.TryGetProperty("command", out _)).Select(TimeOf)
                .Concat(Events.Where(e => e.Id is ReturnActivated or Failsafe).Select(e => e.Time));
        }
    }

    /// <summary>When HEARTBEATs came: every second, or at 5 Hz where that was set in the autopilot's shell.</summary>
    public double HeartbeatPeriod => Root.GetProperty("scenario").GetString()!.Contains("5 Hz") ? 0.2014 : 1.00675;

    public static Px4Recording Read(string name)
    {
        string path = Path.Combine(AppContext.BaseDirectory, "data", "autopilots", name + ".json");
        return new Px4Recording(JsonDocument.Parse(File.ReadAllText(path)).RootElement.Clone());
    }

    public static double TimeOf(JsonElement item) => item.GetProperty("t").GetDouble();

    private static string Text(JsonElement item, string name) => item.GetProperty(name).ToString();

    private JsonElement[] Items(string name)
        => Root.TryGetProperty(name, out JsonElement items) ? items.EnumerateArray().ToArray() : [];
}
