using System;
using System.Text.Json;

namespace Rabit.Uav.Json;

/// <summary>
/// Whether the texts of a document can be read. The parser of the runtime leaves that to the moment when one is asked
/// for: bytes of another encoding, as Latin-1, or half of a surrogate pair as an escape, are an exception of no type of
/// JSON there.
/// </summary>
internal static class JsonTexts
{
    /// <summary>Refuses a document with a name or a text that cannot be read.</summary>
    /// <param name="root">Of the document.</param>
    /// <exception cref="JsonException">There is one; the text names where.</exception>
    public static void Demand(JsonElement root)
    {
        if (FindFault(root) is { } path)
            throw new JsonException($"{path} is a text that cannot be read: the file must be UTF-8");
    }

    // Its path; null where there is none. The parser bounds the depth.
    private static string? FindFault(JsonElement element)
    {
        switch (element.ValueKind)
        {
            case JsonValueKind.String:
                return TryRead(element.GetString) is null ? string.Empty : null;
            case JsonValueKind.Object:
                foreach (JsonProperty property in element.EnumerateObject())
                {
                    if (TryRead(() => property.Name) is not { } name)
                        return "(a name)";
                    if (FindFault(property.Value) is { } below)
                        return Join(name, below);
                }

                return null;
            case JsonValueKind.Array:
                return FindFaultInList(element);
            default:
                return null;
        }
    }

    private static string? FindFaultInList(JsonElement list)
    {
        int index = 0;
        foreach (JsonElement entry in list.EnumerateArray())
        {
            if (FindFault(entry) is { } below)
                return Join(FormattableString.Invariant($"[{index}]"), below);
            index++;
        }

        return null;
    }

    private static string Join(string name, string below)
        => below.Length == 0 || below[0] == '[' ? name + below : $"{name}.{below}";

    private static string? TryRead(Func<string?> read)
    {
        try
        {
            return read();
        }
        catch (InvalidOperationException)
        {
            return null;
        }
    }
}
