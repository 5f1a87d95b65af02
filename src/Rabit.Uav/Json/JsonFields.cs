using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;

namespace Rabit.Uav.Json;

/// <summary>
/// The properties of one JSON object, read one by one. What is not of the kind it should be becomes a fault with path
/// and value, and so does a property that is not read, and one that has another name now. All faults of a document are
/// collected in one list.
/// </summary>
internal sealed class JsonFields
{
    private const int MaxValueLength = 40;

    private readonly string _prefix;
    private readonly List<string> _faults;
    private readonly Dictionary<string, JsonElement> _values = new(StringComparer.Ordinal);
    private readonly List<string> _known = [];
    // new names of properties that are there under their old ones
    private readonly HashSet<string> _renamed = new(StringComparer.Ordinal);

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

    /// <summary>
    /// Blames properties that are there under the name of an older form, with the name that they have now.
    /// </summary>
    public void Renamed(params (string Old, string New)[] names)
    {
        foreach ((string old, string now) in names.Where(n => Has(n.Old)))
        {
            _faults.Add($"{_prefix}{old} is of an older form of the file; it is {_prefix}{now} now");
            _renamed.Add(now);
        }

        _known.RemoveAll(k => names.Any(n => n.Old == k) && !_values.ContainsKey(k));
    }

    public bool Has(string name)
    {
        if (!_known.Contains(name))
            _known.Add(name);
        return _values.TryGetValue(name, out JsonElement value) && value.ValueKind != JsonValueKind.Null;
    }

    /// <summary>The names of all properties that are there.</summary>
    public IReadOnlyCollection<string> Names => _values.Keys;

    public double? Number(string name)
    {
        if (!Has(name))
            return null;
        JsonElement value = _values[name];
        if (value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out double number)
            && !double.IsInfinity(number))
            return number;
        Blame(name, value, "must be a number");
        return double.NaN;
    }

    public double RequiredNumber(string name) => Number(name) ?? Missing(name);

    public int RequiredWholeNumber(string name)
    {
        if (!Has(name))
        {
            Missing(name);
            return 0;
        }

        JsonElement value = _values[name];
        if (value.ValueKind == JsonValueKind.Number && value.TryGetInt32(out int number))
            return number;
        Blame(name, value, "must be a whole number");
        return 0;
    }

    /// <summary>A whole number of 64 bits; null where there is none, which is not blamed.</summary>
    public long? Long(string name)
        => Has(name) && _values[name].ValueKind == JsonValueKind.Number && _values[name].TryGetInt64(out long number)
            ? number
            : null;

    /// <summary>A list of so many numbers; zeros where it is another.</summary>
    public double[] RequiredNumbers(string name, int count) => RequiredNumbers(name, count, count);

    /// <summary>A list of one of two lengths; zeros, as many as the first, where it is another.</summary>
    public double[] RequiredNumbers(string name, int count, int otherCount)
    {
        double[] values = new double[count];
        if (!Has(name))
        {
            Missing(name);
            return values;
        }

        JsonElement list = _values[name];
        if (list.ValueKind == JsonValueKind.Array && list.GetArrayLength() == otherCount)
            values = new double[otherCount];
        if (!TryFill(list, values, 0, values.Length))
        {
            string counts = count == otherCount
                ? FormattableString.Invariant($"{count}")
                : FormattableString.Invariant($"{count} or {otherCount}");
            Blame(name, list, $"must be a list of {counts} numbers");
        }

        return values;
    }

    /// <summary>Three lists of three numbers, row by row; zeros where it is something else.</summary>
    public double[] RequiredMatrix(string name)
    {
        double[] values = new double[9];
        if (!Has(name))
        {
            Missing(name);
            return values;
        }

        JsonElement rows = _values[name];
        bool isMatrix = rows.ValueKind == JsonValueKind.Array && rows.GetArrayLength() == 3;
        for (int row = 0; isMatrix && row < 3; row++)
            isMatrix = TryFill(rows[row], values, 3 * row, 3);
        if (!isMatrix)
            Blame(name, rows, "must be a list of three lists of three numbers");
        return values;
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

    /// <summary>One of some words; null where it is not there or another, which is blamed.</summary>
    public string? Choice(string name, params string[] words)
    {
        if (!Has(name))
            return null;
        JsonElement value = _values[name];
        if (value.ValueKind == JsonValueKind.String && System.Array.IndexOf(words, value.GetString()) >= 0)
            return value.GetString();
        Blame(name, value, "must be one of " + string.Join(", ", words));
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

    /// <summary>A value of any kind; null where there is none.</summary>
    public JsonElement? Any(string name) => Has(name) ? _values[name] : default(JsonElement?);

    /// <summary>The properties of an object in here; none where it is not there.</summary>
    public JsonFields Object(string name)
    {
        JsonElement value = Has(name) ? _values[name] : default;
        if (value.ValueKind is not (JsonValueKind.Object or JsonValueKind.Undefined))
            Blame(name, value, "must be an object, { ... }");
        return new JsonFields(value, _prefix + name, _faults);
    }

    /// <summary>
    /// The properties of an object in here; where it is missing, that is the one fault, and not what would be in it.
    /// </summary>
    public JsonFields RequiredObject(string name)
    {
        if (Has(name) && _values[name].ValueKind == JsonValueKind.Object)
            return Object(name);
        _faults.Add($"{_prefix}{name} is missing or no object, {{ ... }}");
        return new JsonFields(default, _prefix + name, []);
    }

    /// <summary>Blames that something is not there; one that was there and wrong is blamed already.</summary>
    public double Missing(string name)
    {
        if (!Has(name) && !_renamed.Contains(name))
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

    /// <summary>
    /// Blames the properties that were not read: a wrongly spelt one would silently be left to its default.
    /// </summary>
    public void RefuseOthers()
    {
        foreach (string name in _values.Keys.Where(n => !_known.Contains(n)))
        {
            string? near = _known.FirstOrDefault(
                k => name.Length >= 3 && k.StartsWith(name, StringComparison.OrdinalIgnoreCase))
                ?? _known.OrderBy(k => Distance(k, name))
                    .FirstOrDefault(k => Distance(k, name) <= Math.Max(2, name.Length / 3));
            _faults.Add(
                $"{_prefix}{name} is unknown; "
                    + (near is null ? "there are " + string.Join(", ", _known) : $"did you mean {near}?"));
        }
    }

    private static bool TryFill(JsonElement list, double[] values, int at, int count)
    {
        if (list.ValueKind != JsonValueKind.Array || list.GetArrayLength() != count)
            return false;
        for (int i = 0; i < count; i++)
        {
            if (list[i].ValueKind != JsonValueKind.Number || !list[i].TryGetDouble(out values[at + i]))
                return false;
        }

        return true;
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
