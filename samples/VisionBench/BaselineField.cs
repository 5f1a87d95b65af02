using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text.Json;

namespace VisionBench;

/// <summary>A field of the file of the reference's figures, which names file and field where it is wrong.</summary>
internal readonly struct BaselineField
{
    private readonly JsonElement _json;
    private readonly string _file;

    private BaselineField(JsonElement json, string file, string name)
        => (_json, _file, Name) = (json, file, name);

    /// <summary>From the root of the file, with dots.</summary>
    public string Name { get; }

    /// <summary>What the file beside a set has for it; null where there is no file, or no such set in it.</summary>
    /// <exception cref="FormatException">It cannot be understood.</exception>
    public static BaselineField? OfSet(string folder)
    {
        var set = new DirectoryInfo(folder);
        string path = Path.Combine(set.Parent?.FullName ?? ".", "baseline.json");
        if (!File.Exists(path))
            return null;
        try
        {
            using var json = JsonDocument.Parse(File.ReadAllText(path));
            return new BaselineField(json.RootElement.Clone(), path, "").Of("sets").Find(set.Name);
        }
        catch (JsonException e)
        {
            throw new FormatException($"{path} is no JSON: {e.Message}", e);
        }
    }

    /// <summary>Null where there is none.</summary>
    public BaselineField? Find(string name)
    {
        if (_json.ValueKind != JsonValueKind.Object)
            throw Wrong("an object");
        return _json.TryGetProperty(name, out JsonElement json)
            ? new BaselineField(json, _file, Name.Length == 0 ? name : $"{Name}.{name}")
            : null;
    }

    public BaselineField Of(string name)
        => Find(name)
            ?? throw new FormatException($"{_file}: \"{(Name.Length == 0 ? name : $"{Name}.{name}")}\" is missing");

    public int Integer()
        => _json.ValueKind == JsonValueKind.Number && _json.TryGetInt32(out int value)
            ? value : throw Wrong("a whole number");

    public double Number()
        => _json.ValueKind == JsonValueKind.Number ? _json.GetDouble() : throw Wrong("a number");

    public string Text()
        => _json.ValueKind == JsonValueKind.String ? _json.GetString()! : throw Wrong("a text");

    /// <summary>As "found/of".</summary>
    public string Count()
    {
        string text = Text();
        string[] parts = text.Split('/');
        return parts.Length == 2 && Array.TrueForAll(
            parts, p => int.TryParse(p, NumberStyles.None, CultureInfo.InvariantCulture, out _))
            ? text
            : throw Wrong("a count as 5/9");
    }

    /// <summary>All that are in it, with their names there.</summary>
    public IEnumerable<(string Name, BaselineField Field)> All()
    {
        if (_json.ValueKind != JsonValueKind.Object)
            throw Wrong("an object");
        foreach (JsonProperty one in _json.EnumerateObject())
            yield return (one.Name, Of(one.Name));
    }

    private FormatException Wrong(string expected)
        => new(Name.Length == 0 ? $"{_file} is not {expected}" : $"{_file}: \"{Name}\" is not {expected}");
}
