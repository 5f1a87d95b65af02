using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The properties of one JSON object, read one by one. A value of the wrong kind, an unknown property and one of an old name are faults, each
/// with its path; reading goes on, so that all faults are reported together.
/// </summary>
internal sealed class JsonFields
{
    private const int MaxValueLength = 40;

    private readonly string _prefix;
    private readonly List<string> _faults;
    private readonly Dictionary<string, JsonElement> _values = new(StringComparer.Ordinal);
    private readonly List<string> _known = [];
    private readonly Dictionary<string, string> _renamed = new(StringComparer.Ordinal);

    /// <param name="element">An object; anything else has no properties.</param>
    /// <param name="path">Where it is; empty for the root.</param>
    /// <param name="faults">Where faults go.</param>
    public JsonFields(JsonElement element, string path, List<string> faults)
    {
        _prefix = path.Length == 0 ? string.Empty : path + ".";
        _faults = faults;
        if (element.ValueKind != JsonValueKind.Object)
            return;
        foreach (JsonProperty property in element.EnumerateObject())
        {
            if (_values.ContainsKey(property.Name))
                _faults.Add($"{_prefix}{property.Name} is given twice");
            _values[property.Name] = property.Value;
        }
    }

    /// <summary>States the name that a property had in an old form of the file: such a file is refused, with the new name.</summary>
    public void Renamed(string oldName, string newName) => _renamed[oldName] = newName;

    public bool Has(string name)
    {
        if (!_known.Contains(name))
            _known.Add(name);
        return _values.TryGetValue(name, out JsonElement value) && value.ValueKind != JsonValueKind.Null;
    }

    public double? Number(string name)
    {
        if (!Has(name))
            return null;
        JsonElement value = _values[name];
        if (value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out double number) && !double.IsInfinity(number))
            return number;
        Fault(name, value, "must be a number");
        return double.NaN;
    }

    public bool? Flag(string name)
    {
        if (!Has(name))
            return null;
        JsonElement value = _values[name];
        if (value.ValueKind is JsonValueKind.True or JsonValueKind.False)
            return value.GetBoolean();
        Fault(name, value, "must be true or false");
        return null;
    }

    public string? Text(string name)
    {
        if (!Has(name))
            return null;
        JsonElement value = _values[name];
        if (value.ValueKind == JsonValueKind.String)
            return value.GetString();
        Fault(name, value, "must be a string");
        return null;
    }

    public JsonElement? Array(string name)
    {
        if (!Has(name))
            return null;
        JsonElement value = _values[name];
        if (value.ValueKind == JsonValueKind.Array)
            return value;
        Fault(name, value, "must be a list, [ ... ]");
        return default(JsonElement?);
    }

    /// <summary>The properties of a nested object; none where it is missing.</summary>
    public JsonFields Object(string name)
    {
        JsonElement value = Has(name) ? _values[name] : default;
        if (value.ValueKind is not (JsonValueKind.Object or JsonValueKind.Undefined))
            Fault(name, value, "must be an object, { ... }");
        return new JsonFields(value, _prefix + name, _faults);
    }

    /// <summary>Reports that a property is missing, unless it is given, or under its old name, which is a fault of its own.</summary>
    public double Missing(string name)
    {
        if (!Has(name) && !_renamed.Any(r => r.Value == name && _values.ContainsKey(r.Key)))
            _faults.Add($"{_prefix}{name} is missing");
        return double.NaN;
    }

    public void Fault(string name, JsonElement value, string text)
    {
        string shown = value.GetRawText().Replace("\r", string.Empty).Replace("\n", " ");
        if (shown.Length > MaxValueLength)
            shown = shown.Remove(MaxValueLength) + "...";
        _faults.Add($"{_prefix}{name} is {shown}; it {text}");
    }

    /// <summary>Reports the properties that were not read: a misspelt one would otherwise keep its default in silence.</summary>
    public void RejectOthers()
    {
        foreach (string name in _values.Keys.Where(n => !_known.Contains(n)))
        {
            if (_renamed.TryGetValue(name, out string? newName))
            {
                _faults.Add($"{_prefix}{name} is a name of the old form; it is now {_prefix}{newName}");
                continue;
            }

            string? near = _known.FirstOrDefault(k => name.Length >= 3 && k.StartsWith(name, StringComparison.OrdinalIgnoreCase))
                ?? _known.OrderBy(k => Distance(k, name)).FirstOrDefault(k => Distance(k, name) <= Math.Max(2, name.Length / 3));
            _faults.Add($"{_prefix}{name} is unknown; "
                + (near is null ? "there are " + string.Join(", ", _known) : $"did you mean {near}?"));
        }
    }

    // Levenshtein distance, without regard to case.
    private static int Distance(string a, string b)
    {
        int[] row = Enumerable.Range(0, b.Length + 1).ToArray();
        for (int i = 1; i <= a.Length; i++)
        {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j <= b.Length; j++)
            {
                int exchanged = diagonal + (char.ToUpperInvariant(a[i - 1]) == char.ToUpperInvariant(b[j - 1]) ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.Min(exchanged, Math.Min(row[j], row[j - 1]) + 1);
            }
        }

        return row[b.Length];
    }
}
