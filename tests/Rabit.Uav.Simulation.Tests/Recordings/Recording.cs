using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink;

namespace Rabit.Uav.Simulation.Tests.Recordings;

/// <summary>A recorded flight of a real autopilot: tests/data/autopilots, described in its README.</summary>
internal sealed class Recording
{
    private readonly JsonElement _json;

    private Recording(string name)
    {
        Name = name;
        using FileStream file = File.OpenRead(PathOf(name + ".json"));
        using JsonDocument document = JsonDocument.Parse(file);
        _json = document.RootElement.Clone();
        CompanionFrames = ReadFrames(PathOf(name + ".companion.tlog"));
    }

    public string Name { get; }

    /// <summary>What the companion sent, by the time since the first record.</summary>
    public IReadOnlyList<(TimeSpan Time, MavlinkFrame Frame)> CompanionFrames { get; }

    public JsonElement Home => _json.GetProperty("home");

    public double Seconds => _json.GetProperty("duration_s").GetDouble();

    public IEnumerable<JsonElement> Actions => All("actions");

    public IEnumerable<(string Name, double Value)> StartParameters
        => _json.GetProperty("start_parameters").EnumerateObject().Select(p => (p.Name, p.Value.GetDouble()));

    /// <summary>Set by the ground station.</summary>
    public IEnumerable<(double Time, string Name, double Value)> ParametersSet
        => All("parameters_set").Select(
            p => (Time(p), p.GetProperty("name").GetString()!, p.GetProperty("value").GetDouble()));

    /// <summary>Where mode, arming or MAV_STATE change.</summary>
    public IEnumerable<(double Time, string State)> ModeReports
        => Changes(All("mode_reports").Select(m => (Time(m), string.Join(
            " ",
            m.GetProperty("mode").GetString(),
            m.GetProperty("armed").GetBoolean() ? "armed" : "disarmed",
            m.GetProperty("system_status").GetInt32()))));

    public IEnumerable<(double Time, string State)> LandedStates
        => All("landed_states").Select(s => (Time(s), s.GetProperty("name").GetString()!.Replace("_", string.Empty)));

    public IEnumerable<(double Time, string Text)> Texts
        => All("statustext").Select(s => (Time(s), s.GetProperty("text").GetString()!));

    public IEnumerable<string> Acknowledgements
        => All("command_acks_heard").Select(
            a => a.GetProperty("command").GetInt32() + " "
                + a.GetProperty("result").GetString()!.Replace("_", string.Empty));

    public static Recording Read(string name) => new(name);

    /// <summary>Names of the actions, by the time at which something was done to the vehicle.</summary>
    public double LastCauseBefore(double time)
        => Actions.Where(a => !a.GetProperty("action").GetString()!.Contains("starts")).Select(Time)
            .Concat(ParametersSet.Select(p => p.Time))
            .Where(t => t <= time).DefaultIfEmpty(0).Max();

    public static double Time(JsonElement element) => element.GetProperty("t").GetDouble();

    private static IEnumerable<(double Time, string State)> Changes(IEnumerable<(double Time, string State)> reports)
    {
        string? last = null;
        foreach ((double time, string state) in reports)
        {
            if (state != last)
                yield return (time, state);
            last = state;
        }
    }

    private IEnumerable<JsonElement> All(string name)
    {
        if (!_json.TryGetProperty(name, out JsonElement array))
            yield break;
        foreach (JsonElement element in array.EnumerateArray())
            yield return element;
    }

    private static string PathOf(string file) => Path.Combine(AppContext.BaseDirectory, "data", "autopilots", file);

    private static List<(TimeSpan Time, MavlinkFrame Frame)> ReadFrames(string path)
    {
        using FileStream file = File.OpenRead(path);
        var reader = new TlogReader(file, MavlinkDialect.All);
        var frames = new List<(TimeSpan, MavlinkFrame)>();
        DateTime? start = null;
        while (reader.TryRead(out MavlinkFrame frame, out TlogRecord record))
        {
            bool isFirst = start is null;
            start ??= record.TimeUtc;
            if (!isFirst || frame.ComponentId != 1)
                frames.Add((record.TimeUtc - start.Value, frame));
        }

        return frames;
    }
}
