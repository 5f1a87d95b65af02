using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Uav.ImageProcessing;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The properties of one JSON object, taken out one by one: what is not of the kind it should be is blamed with path and value, and so
/// is what nobody asked for.
/// </summary>
internal sealed class JsonFields
{
    private const int MaxValueLength = 40;

    private readonly string _prefix;
    private readonly List<string> _faults;
    private readonly Dictionary<string, JsonElement> _values = new(StringComparer.Ordinal);
    private readonly List<string> _known = [];

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
                _faults.Add($"{_prefix}{property.Name} is there twice");
            _values[property.Name] = property.Value;
        }
    }

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
        Blame(name, value, "must be a number");
        return double.NaN;
    }

    public bool? Flag(string name)
    {
        if (!Has(name))
            return null;
        JsonElement value = _values[name];
        if (value.ValueKind is JsonValueKind.True or JsonValueKind.False)
            return value.GetBoolean();
        Blame(name, value, "must be true or false");
        return null;
    }

    public string? Text(string name)
    {
        if (!Has(name))
            return null;
        JsonElement value = _values[name];
        if (value.ValueKind == JsonValueKind.String)
            return value.GetString();
        Blame(name, value, "must be a text");
        return null;
    }

    public JsonElement? Array(string name)
    {
        if (!Has(name))
            return null;
        JsonElement value = _values[name];
        if (value.ValueKind == JsonValueKind.Array)
            return value;
        Blame(name, value, "must be a list, [ ... ]");
        return default(JsonElement?);
    }

    /// <summary>The properties of an object in here; none where it is not there.</summary>
    public JsonFields Object(string name)
    {
        JsonElement value = Has(name) ? _values[name] : default;
        if (value.ValueKind is not (JsonValueKind.Object or JsonValueKind.Undefined))
            Blame(name, value, "must be an object, { ... }");
        return new JsonFields(value, _prefix + name, _faults);
    }

    /// <summary>Blames that something is not there; one that was there and wrong is blamed already.</summary>
    public double Missing(string name)
    {
        if (!Has(name))
            _faults.Add($"{_prefix}{name} is missing");
        return double.NaN;
    }

    public void Blame(string name, JsonElement value, string text)
    {
        string shown = value.GetRawText().Replace("\r", string.Empty).Replace("\n", " ");
        if (shown.Length > MaxValueLength)
            shown = shown.Remove(MaxValueLength) + "...";
        _faults.Add($"{_prefix}{name} is {shown}; it {text}");
    }

    /// <summary>Blames the properties that nobody asked for: a wrongly spelt one would silently be left to its default.</summary>
    public void RefuseOthers()
    {
        foreach (string name in _values.Keys.Where(n => !_known.Contains(n)))
        {
            string? near = _known.FirstOrDefault(k => name.Length >= 3 && k.StartsWith(name, StringComparison.OrdinalIgnoreCase))
                ?? _known.OrderBy(k => Distance(k, name)).FirstOrDefault(k => Distance(k, name) <= Math.Max(2, name.Length / 3));
            _faults.Add($"{_prefix}{name} is unknown; " + (near is null ? "there are " + string.Join(", ", _known) : $"did you mean {near}?"));
        }
    }

    // How many characters must be put in, taken out or exchanged (Levenshtein), without regard to case.
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
