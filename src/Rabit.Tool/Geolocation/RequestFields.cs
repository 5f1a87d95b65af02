using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;

namespace Rabit.Tool.Geolocation;

/// <summary>
/// The fields of one JSON object. The first that is unknown, missing or of a wrong type is refused with the file and
/// the path of the field: a misspelt one that is left out of account would give the wrong place.
/// </summary>
internal sealed class RequestFields
{
    private readonly string _file;
    private readonly string _prefix;
    private readonly Dictionary<string, JsonElement> _values = new(StringComparer.Ordinal);

    private RequestFields(JsonElement element, string file, string path, string[] known)
    {
        (_file, _prefix) = (file, path.Length == 0 ? "" : path + ".");
        if (element.ValueKind != JsonValueKind.Object)
            throw Wrong(path.Length == 0 ? "the whole" : path, element, "an object, { ... }");
        foreach (JsonProperty property in element.EnumerateObject())
        {
            string name = property.Name;
            if (OldNames.NewNameOf(name) is { } now && known.Contains(now))
                throw new FormatException(
                    $"{file}: {_prefix}{name} is of an older form of the file; it is {_prefix}{now} now");
            if (!known.Contains(name))
                throw new FormatException($"{file}: {_prefix}{name} is unknown; there are {string.Join(", ", known)}");
            if (_values.ContainsKey(name))
                throw new FormatException($"{file}: {_prefix}{name} is there twice");
            _values[name] = property.Value;
        }
    }

    /// <param name="json">The text of a document.</param>
    /// <param name="file">What it is called.</param>
    /// <param name="known">Names of the fields that it may have.</param>
    /// <exception cref="FormatException">It is no JSON, no object, or has other fields.</exception>
    public static RequestFields Parse(string json, string file, params string[] known)
    {
        try
        {
            using JsonDocument document = JsonDocument.Parse(json);
            return new RequestFields(document.RootElement.Clone(), file, "", known);
        }
        catch (JsonException e)
        {
            throw new FormatException($"{file}: it is not JSON: {e.Message}", e);
        }
        catch (InvalidOperationException e)
        {
            // The runtime's, for half of a surrogate pair.
            throw new FormatException($"{file}: a name in it cannot be read: {e.Message}", e);
        }
    }

    public bool Has(string name) => _values.ContainsKey(name);

    public RequestFields Object(string name, params string[] known)
        => new(Required(name), _file, _prefix + name, known);

    public double Number(string name) => Number(Required(name), name);

    public double OptionalNumber(string name) => Has(name) ? Number(name) : 0;

    /// <summary>A number within the range of a field; 0 where it may be missing and is.</summary>
    public double Number(in PoseField field)
    {
        if (field.IsOptional && !Has(field.Name))
            return 0;
        double number = Number(field.Name);
        return field.Holds(number) ? number : throw Wrong(_prefix + field.Name, _values[field.Name], field.Range);
    }

    /// <summary>A list of two numbers.</summary>
    public (double First, double Second) Pair(string name) => Pair(Required(name), name);

    /// <summary>A list of such lists, 1 to <paramref name="max"/>.</summary>
    public IReadOnlyList<(double First, double Second)> Pairs(string name, int max)
    {
        JsonElement list = Required(name);
        if (list.ValueKind != JsonValueKind.Array || list.GetArrayLength() == 0)
            throw Wrong(_prefix + name, list, "a list of lists of two numbers, [[ ... ], ...]");
        return list.GetArrayLength() <= max
            ? [.. list.EnumerateArray().Select((pair, i) => Pair(pair, FormattableString.Invariant($"{name}[{i}]")))]
            : throw new FormatException(FormattableString.Invariant(
                $"{_file}: {_prefix}{name} has {list.GetArrayLength()} entries; it may have {max} at most"));
    }

    private (double First, double Second) Pair(JsonElement list, string name)
    {
        if (list.ValueKind != JsonValueKind.Array || list.GetArrayLength() != 2)
            throw Wrong(_prefix + name, list, "a list of two numbers");
        return (Number(list[0], name + "[0]"), Number(list[1], name + "[1]"));
    }

    /// <summary>What is wrong with several fields at once.</summary>
    public FormatException Fault(string text) => new($"{_file}: {text}");

    private double Number(JsonElement value, string name)
        => value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out double number)
            && !double.IsInfinity(number)
            ? number : throw Wrong(_prefix + name, value, "a number");

    private JsonElement Required(string name)
        => _values.TryGetValue(name, out JsonElement value)
            ? value
            : throw new FormatException($"{_file}: {_prefix}{name} is missing");

    private FormatException Wrong(string path, JsonElement value, string wanted)
    {
        const int MaxShown = 40;
        string shown = value.GetRawText().Replace("\r", "").Replace("\n", " ");
        return new FormatException(
            $"{_file}: {path} is {(shown.Length > MaxShown ? shown.Remove(MaxShown) + "..." : shown)}; it must be "
                + $"{wanted}");
    }
}
