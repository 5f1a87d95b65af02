using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;

namespace VisionBench;

/// <summary>Fields of a truth or a manifest; what is missing or of a wrong kind is named by its path.</summary>
internal static class TruthJson
{
    /// <exception cref="FormatException">There is none, or this is no object.</exception>
    public static JsonElement FieldOf(this JsonElement json, string name)
    {
        if (json.ValueKind != JsonValueKind.Object)
            throw new FormatException("it must be an object, { ... }");
        return json.TryGetProperty(name, out JsonElement field)
            ? field
            : throw new FormatException($"\"{name}\" is missing");
    }

    /// <exception cref="FormatException">It is none.</exception>
    public static string TextOf(this JsonElement json, string name)
        => json.FieldOf(name) is { ValueKind: JsonValueKind.String } field
            ? field.GetString()!
            : throw Wrong(name, "a text");

    /// <exception cref="FormatException">It is none.</exception>
    public static bool FlagOf(this JsonElement json, string name)
        => json.FieldOf(name) is { ValueKind: JsonValueKind.True or JsonValueKind.False } field
            ? field.GetBoolean()
            : throw Wrong(name, "true or false");

    /// <exception cref="FormatException">It is none.</exception>
    public static double NumberOf(this JsonElement json, string name)
        => json.FieldOf(name) is { ValueKind: JsonValueKind.Number } field
            ? field.GetDouble()
            : throw Wrong(name, "a number");

    /// <exception cref="FormatException">It is none.</exception>
    public static int WholeOf(this JsonElement json, string name)
        => json.FieldOf(name) is { ValueKind: JsonValueKind.Number } field && field.TryGetInt32(out int number)
            ? number
            : throw Wrong(name, "a whole number");

    /// <exception cref="FormatException">It is no list of so many numbers.</exception>
    public static double[] NumbersOf(this JsonElement json, string name, int count)
        => Numbers(json.FieldOf(name), count)
            ?? throw Wrong(name, FormattableString.Invariant($"a list of {count} numbers"));

    /// <summary>A list of so many numbers; null where it is none.</summary>
    public static double[]? Numbers(JsonElement list, int count)
        => list.ValueKind == JsonValueKind.Array && list.GetArrayLength() == count
            && list.EnumerateArray().All(n => n.ValueKind == JsonValueKind.Number)
            ? [.. list.EnumerateArray().Select(n => n.GetDouble())]
            : null;

    /// <summary>What is made of each entry of a list; which entry it is, is in its errors.</summary>
    /// <exception cref="FormatException">It is no list, or an entry is wrong.</exception>
    public static IEnumerable<T> EachOf<T>(this JsonElement json, string name, Func<JsonElement, int, T> make)
        => json.FieldOf(name) is { ValueKind: JsonValueKind.Array } list
            ? Each(list, name, make)
            : throw Wrong(name, "a list, [ ... ]");

    /// <inheritdoc cref="EachOf"/>
    public static IEnumerable<T> Each<T>(JsonElement list, string name, Func<JsonElement, int, T> make)
    {
        int index = 0;
        foreach (JsonElement entry in list.EnumerateArray())
        {
            T made;
            try
            {
                made = make(entry, index);
            }
            catch (FormatException e)
            {
                throw new FormatException(FormattableString.Invariant($"{name}[{index}]: {e.Message}"), e);
            }

            index++;
            yield return made;
        }
    }

    private static FormatException Wrong(string name, string expected) => new($"\"{name}\" must be {expected}");
}
