using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;

namespace Rabit.Tool.Training;

/// <summary>
/// The fields of an object in a file of labels; unknown, missing and wrong ones are named with their path.
/// </summary>
internal sealed class LabelFields
{
    private readonly JsonElement _element;
    private readonly string _file;
    private readonly string _prefix;

    public LabelFields(JsonElement element, string file, string path, params string[] known)
    {
        (_element, _file, _prefix) = (element, file, path.Length == 0 ? "" : path + ".");
        if (element.ValueKind != JsonValueKind.Object)
        {
            string what = path.Length == 0 ? "the whole" : path;
            throw new FormatException($"{file}: {what} must be an object, {{ ... }}");
        }

        var names = new HashSet<string>(StringComparer.Ordinal);
        foreach (JsonProperty property in element.EnumerateObject())
        {
            if (!names.Add(property.Name))
                throw new FormatException($"{file}: {_prefix}{property.Name} is there twice");
            if (!known.Contains(property.Name))
                throw new FormatException(
                    $"{file}: {_prefix}{property.Name} is unknown; there are {string.Join(", ", known)}");
        }
    }

    public bool Has(string name) => _element.TryGetProperty(name, out _);

    public double Number(string name)
        => Required(name) is { ValueKind: JsonValueKind.Number } value && value.TryGetDouble(out double number)
            && !double.IsInfinity(number)
            ? number
            : throw Wrong(name, "a number");

    public double NumberFrom(string name, double min)
        => Number(name) is var number && number >= min
            ? number
            : throw new FormatException(FormattableString.Invariant(
                $"{_file}: {_prefix}{name} is {number}; it must be {min} at least"));

    public double NumberWithin(string name, double max)
        => Number(name) is var number && Math.Abs(number) <= max
            ? number
            : throw new FormatException(FormattableString.Invariant(
                $"{_file}: {_prefix}{name} is {number}; it must be -{max} to {max}"));

    public string Text(string name)
        => Required(name) is { ValueKind: JsonValueKind.String } value && value.GetString()!.Length > 0
            ? value.GetString()!
            : throw Wrong(name, "a text");

    public bool Flag(string name) => Required(name).ValueKind switch
    {
        JsonValueKind.True => true,
        JsonValueKind.False => false,
        _ => throw Wrong(name, "true or false"),
    };

    public IEnumerable<JsonElement> List(string name)
        => Required(name) is { ValueKind: JsonValueKind.Array } value
            ? value.EnumerateArray()
            : throw Wrong(name, "a list, [ ... ]");

    private JsonElement Required(string name)
        => _element.TryGetProperty(name, out JsonElement value)
            ? value
            : throw new FormatException($"{_file}: {_prefix}{name} is missing");

    private FormatException Wrong(string name, string wanted)
        => new($"{_file}: {_prefix}{name} must be {wanted}");
}
