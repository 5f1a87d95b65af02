using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text.Json;

namespace Rabit.Mavlink.Protocols;

/// <summary>Reads the JSON of libevents; everything wrong with it is a FormatException with the place.</summary>
internal sealed class EventCatalogReader(JsonElement root)
{
    private const int OldestVersion = 1;
    private const int NewestVersion = 2;
    private const int SubIdBits = 24;

    private readonly Dictionary<string, EventArgumentType> _types = new(StringComparer.Ordinal)
    {
        ["uint8_t"] = new EventArgumentType(EventNumber.UInt8),
        ["int8_t"] = new EventArgumentType(EventNumber.Int8),
        ["uint16_t"] = new EventArgumentType(EventNumber.UInt16),
        ["int16_t"] = new EventArgumentType(EventNumber.Int16),
        ["uint32_t"] = new EventArgumentType(EventNumber.UInt32),
        ["int32_t"] = new EventArgumentType(EventNumber.Int32),
        ["uint64_t"] = new EventArgumentType(EventNumber.UInt64),
        ["int64_t"] = new EventArgumentType(EventNumber.Int64),
        ["float"] = new EventArgumentType(EventNumber.Single),
    };

    private readonly Dictionary<uint, MavlinkEventDefinition> _definitions = [];

    public Dictionary<uint, MavlinkEventDefinition> Read()
    {
        if (root.ValueKind != JsonValueKind.Object || !root.TryGetProperty("version", out JsonElement version))
            throw new FormatException("no file of events: it has no \"version\"");
        if (version.ValueKind != JsonValueKind.Number || !version.TryGetInt32(out int number)
            || number is < OldestVersion or > NewestVersion)
            throw new FormatException($"version {version} of a file of events; versions 1 and 2 are known");

        // Enums first: the events of one component may use those of another.
        foreach (JsonProperty component in Members(root, "components", "the file"))
            ReadEnums(component);
        foreach (JsonProperty component in Members(root, "components", "the file"))
            ReadEvents(component);
        return _definitions;
    }

    private static JsonElement.ObjectEnumerator Members(JsonElement parent, string name, string place)
    {
        if (parent.ValueKind != JsonValueKind.Object)
            throw new FormatException($"{place}: no object");
        if (!parent.TryGetProperty(name, out JsonElement members))
            return default;   // there are none
        return members.ValueKind == JsonValueKind.Object
            ? members.EnumerateObject()
            : throw new FormatException($"{place}: \"{name}\" is no object");
    }

    private static string Text(JsonElement parent, string name, string place, string? missing = null)
    {
        if (parent.ValueKind == JsonValueKind.Object && !parent.TryGetProperty(name, out _) && missing is not null)
            return missing;
        return parent.ValueKind == JsonValueKind.Object && parent.TryGetProperty(name, out JsonElement value)
            && value.ValueKind == JsonValueKind.String
            ? value.GetString()!
            : throw new FormatException($"{place}: \"{name}\" is no text");
    }

    private void ReadEnums(JsonProperty component)
    {
        string place = "component " + component.Name;
        string prefix = Text(component.Value, "namespace", place) + "::";
        foreach (JsonProperty item in Members(component.Value, "enums", place))
            _types[prefix + item.Name] = ReadEnum(item.Value, $"{place}, enum {item.Name}");
    }

    private static EventArgumentType ReadEnum(JsonElement item, string place)
    {
        var texts = new Dictionary<ulong, string>();
        EventNumber number = NumberOf(Text(item, "type", place), place);
        foreach (JsonProperty entry in Members(item, "entries", place))
            texts[ValueOf(entry.Name, number, place)] = Text(
                entry.Value, "description", place, missing: Text(entry.Value, "name", place, missing: entry.Name));
        bool isBitfield = item.TryGetProperty("is_bitfield", out JsonElement flag)
            && flag.ValueKind == JsonValueKind.True;
        return new EventArgumentType(number, texts, isBitfield, Text(item, "separator", place, missing: "|"));
    }

    private static EventNumber NumberOf(string type, string place) => type switch
    {
        "uint8_t" => EventNumber.UInt8,
        "int8_t" => EventNumber.Int8,
        "uint16_t" => EventNumber.UInt16,
        "int16_t" => EventNumber.Int16,
        "uint32_t" => EventNumber.UInt32,
        "int32_t" => EventNumber.Int32,
        "uint64_t" => EventNumber.UInt64,
        "int64_t" => EventNumber.Int64,
        _ => throw new FormatException($"{place}: '{type}' is no whole number"),
    };

    // Negative values as the bytes of their type have them.
    private static ulong ValueOf(string text, EventNumber number, string place)
    {
        if (ulong.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out ulong value))
            return value;
        if (!long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out long negative))
            throw new FormatException($"{place}: '{text}' is no value");
        return number switch
        {
            EventNumber.Int8 => (byte)negative,
            EventNumber.Int16 => (ushort)negative,
            EventNumber.Int32 => (uint)negative,
            _ => (ulong)negative,
        };
    }

    private void ReadEvents(JsonProperty component)
    {
        string place = "component " + component.Name;
        if (!byte.TryParse(component.Name, NumberStyles.None, CultureInfo.InvariantCulture, out byte id))
            throw new FormatException($"{place}: the number of a component is 0 to 255");
        string prefix = Text(component.Value, "namespace", place) + "::";
        foreach (JsonProperty group in Members(component.Value, "event_groups", place))
        {
            foreach (JsonProperty item in Members(group.Value, "events", $"{place}, group {group.Name}"))
                ReadEvent(id, prefix, group.Name, item);
        }
    }

    private void ReadEvent(byte component, string prefix, string group, JsonProperty item)
    {
        string place = $"component {component}, event {item.Name}";
        if (!uint.TryParse(item.Name, NumberStyles.None, CultureInfo.InvariantCulture, out uint subId)
            || subId >> SubIdBits != 0)
            throw new FormatException($"{place}: the number of an event has 24 bits");
        uint id = ((uint)component << SubIdBits) | subId;
        _definitions[id] = new MavlinkEventDefinition(
            id, prefix + Text(item.Value, "name", place), group, Text(item.Value, "message", place),
            Text(item.Value, "description", place, missing: string.Empty), ReadArguments(item.Value, prefix, place));
    }

    private List<EventArgumentType> ReadArguments(JsonElement item, string prefix, string place)
    {
        var types = new List<EventArgumentType>();
        if (!item.TryGetProperty("arguments", out JsonElement arguments))
            return types;
        if (arguments.ValueKind != JsonValueKind.Array)
            throw new FormatException($"{place}: \"arguments\" is no array");
        foreach (JsonElement argument in arguments.EnumerateArray())
        {
            string name = Text(argument, "type", place);
            if (!_types.TryGetValue(name, out EventArgumentType? type)
                && !_types.TryGetValue(prefix + name, out type))
                throw new FormatException($"{place}: there is no type '{name}'");
            types.Add(type);
        }

        return types;
    }
}
