using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;

namespace Rabit.Uav.Simulation;

/// <summary>Reads a truth file and collects all that is wrong with it.</summary>
internal sealed class TruthParser(List<string> faults)
{
    // Files of the first form had these names.
    private static readonly (string Old, string New)[] RenamedKeys =
        [("lat_deg", "latitudeDegrees"), ("lon_deg", "longitudeDegrees"), ("color", "class")];

    // Of a file with many targets, enough to see which entries are meant.
    private const int MaxEntriesNamed = 3;

    private readonly List<(string Rename, List<string> Entries)> _renames = [];

    public TargetTruth Parse(JsonElement root)
    {
        if (root.ValueKind != JsonValueKind.Object || StringOf(root, "format") != TruthFile.Format)
        {
            faults.Add($"it does not say \"format\": \"{TruthFile.Format}\"");
            return new TargetTruth(default, []);
        }

        if (!root.TryGetProperty("version", out JsonElement version) || version.ValueKind != JsonValueKind.Number
            || !version.TryGetInt32(out int number) || number != TruthFile.Version)
        {
            faults.Add($"its version is not {TruthFile.Version}");
        }

        GeodeticPosition home = default;
        if (root.TryGetProperty("home", out JsonElement place))
            home = PositionOf(place, "home");
        else
            faults.Add("home is missing");

        var targets = new List<TruthTarget>();
        if (!root.TryGetProperty("targets", out JsonElement list) || list.ValueKind != JsonValueKind.Array)
            faults.Add("targets is not a list");
        else
            ParseTargets(list, targets);
        foreach ((string rename, List<string> entries) in _renames)
            faults.Add($"{rename} (in {string.Join(", ", entries.Take(MaxEntriesNamed))}"
                + (entries.Count > MaxEntriesNamed ? $" and {entries.Count - MaxEntriesNamed} more)" : ")"));
        return new TargetTruth(home, targets);
    }

    private void ParseTargets(JsonElement list, List<TruthTarget> targets)
    {
        foreach (JsonElement element in list.EnumerateArray())
        {
            string index = $"targets[{targets.Count}]";
            string? name = StringOf(element, "name");
            string where = name is null ? index : $"{index} '{name}'";
            TargetClassName targetClass = TargetClassName.None;
            if (element.ValueKind == JsonValueKind.Object && StringOf(element, "class") is { } text)
            {
                if (!TargetClassName.TryParse(text, out targetClass))
                    faults.Add($"{where}: '{text}' is not a class: 1 to {TargetClassName.MaxLength} ASCII characters");
            }
            else if (!IsRenamed(element, "class", where))
            {
                faults.Add($"{where} has no class");
            }

            targets.Add(new TruthTarget(name ?? index, targetClass, PositionOf(element, where)));
        }
    }

    private GeodeticPosition PositionOf(JsonElement element, string where) => GeodeticPosition.FromDegrees(
        DegreesOf(element, "latitudeDegrees", 90, where), DegreesOf(element, "longitudeDegrees", 180, where), 0);

    private double DegreesOf(JsonElement element, string name, double limit, string where)
    {
        if (element.ValueKind == JsonValueKind.Object && element.TryGetProperty(name, out JsonElement value)
            && value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out double degrees)
            && Math.Abs(degrees) <= limit)
            return degrees;
        if (!IsRenamed(element, name, where))
            faults.Add($"{where}: {name} is not a number from {-limit} to {limit}");
        return 0;
    }

    // Said once for each key, at the end, with the entries that have it.
    private bool IsRenamed(JsonElement element, string name, string where)
    {
        foreach ((string old, string renamed) in RenamedKeys)
        {
            if (renamed != name || element.ValueKind != JsonValueKind.Object || !element.TryGetProperty(old, out _))
                continue;
            string rename = $"{old} is now {renamed}";
            if (!_renames.Exists(r => r.Rename == rename))
                _renames.Add((rename, []));
            _renames.Find(r => r.Rename == rename).Entries.Add(where);
            return true;
        }

        return false;
    }

    private static string? StringOf(JsonElement element, string name)
        => element.ValueKind == JsonValueKind.Object && element.TryGetProperty(name, out JsonElement value)
            && value.ValueKind == JsonValueKind.String
            ? value.GetString()
            : null;
}
