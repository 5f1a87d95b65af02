using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;

namespace Rabit.Uav.Tests;

/// <summary>What the .json beside a recorded flight lists, as lines to compare.</summary>
internal static class SidecarFacts
{
    private static readonly string[] RangeNames = ["lat", "lon", "alt", "relative_alt"];

    /// <summary>Counts by id and source; the sidecar distinguishes directions, a log does not.</summary>
    public static IEnumerable<string> Counts(JsonElement facts) => facts.GetProperty("counts").EnumerateArray()
        .GroupBy(
            c => (Id: c[1].GetInt32(), System: c[2].GetInt32(), Component: c[3].GetInt32(), Version: c[4].GetInt32()))
        .Select(g => Line(g.Key.Id, g.Key.System, g.Key.Component, g.Key.Version, g.Sum(c => c[6].GetInt64())))
        .OrderBy(l => l, StringComparer.Ordinal);

    public static IEnumerable<string> Sources(JsonElement facts) => facts.GetProperty("sequence").EnumerateArray()
        .Select(
            s => Line(
                Number(s, "sysid"), Number(s, "compid"), Number(s, "frames"), Number(s, "missing"),
                Number(s, "out_of_order")));

    public static IEnumerable<string> ModeChanges(JsonElement facts)
        => facts.GetProperty("mode_changes").EnumerateArray()
            .Select(
                e => Line(
                    Number(e, "record"), Number(e, "t_us"), Number(e, "custom_mode"), Number(e, "base_mode"),
                    e.GetProperty("armed").GetBoolean(), Number(e, "system_status")));

    public static IEnumerable<string> Acknowledgements(JsonElement facts)
        => facts.GetProperty("command_acks").EnumerateArray()
            .Select(e => Line(
                Number(e, "record"), Number(e, "t_us"), Number(e, "command"), Number(e, "result"),
                Number(e, "progress"), Number(e, "result_param2"), Number(e, "target_system"),
                Number(e, "target_component")));

    public static IEnumerable<string> Texts(JsonElement facts) => facts.GetProperty("statustext").EnumerateArray()
        .Select(
            e => Line(
                Number(e, "record"), Number(e, "t_us"), Number(e, "sysid"), Number(e, "compid"), Number(e, "severity"),
                e.GetProperty("text").GetString()!));

    public static IEnumerable<string> Ranges(JsonElement facts) => RangeNames.Select(name =>
    {
        JsonElement range = facts.GetProperty("global_position_int").GetProperty(name);
        return Line(name, Number(range, "min"), Number(range, "max"));
    });

    public static string Line(params object[] parts)
        => string.Join(" ", parts.Select(p => Convert.ToString(p, CultureInfo.InvariantCulture)));

    private static long Number(JsonElement element, string name) => element.GetProperty(name).GetInt64();
}
