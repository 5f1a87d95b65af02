using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>
/// The elements and attributes that a definition may have (MAVLink guide, "MAVLink XML schema"; the schema of
/// pymavlink says the same). Attributes that only other tools use, such as <c>print_format</c>, are in it too: they
/// are right, though not read.
/// </summary>
internal static class DefinitionSchema
{
    private static readonly string[] Ages = ["wip", "deprecated", "superseded"];

    private static readonly Dictionary<string, DefinitionElementRule> Rules = new DefinitionElementRule[]
    {
        new("mavlink", [], ["include", "version", "dialect", "enums", "messages"]),
        new("include", [], []),
        new("version", [], []),
        new("dialect", [], []),
        new("enums", [], ["enum"]),
        new("enum", ["name", "bitmask"], [.. Ages, "description", "entry"]),
        new(
            "entry",
            ["name", "value", "hasLocation", "altitudeOnly", "isDestination", "missionOnly"],
            [.. Ages, "description", "param"]),
        new(
            "param",
            [
                "index", "label", "units", "multiplier", "instance", "enum", "decimalPlaces", "increment", "minValue",
                "maxValue", "reserved", "default",
            ],
            []),
        new("messages", [], ["message"]),
        new("message", ["id", "name"], [.. Ages, "description", "field", "extensions"]),
        new(
            "field",
            [
                "type", "name", "print_format", "enum", "display", "units", "increment", "minValue", "maxValue",
                "multiplier", "default", "instance", "invalid",
            ],
            ["description"]),
        new("extensions", [], []),
        new("description", [], []),
        new("wip", ["since"], ["description"]),
        new("superseded", ["since", "replaced_by"], ["description"]),
        new("deprecated", ["since", "replaced_by", "remove_on_date"], ["description"]),
    }.ToDictionary(rule => rule.Name, StringComparer.Ordinal);

    /// <summary>What an element of this name may have, or null where there is none of that name.</summary>
    public static DefinitionElementRule? Find(string element) =>
        Rules.TryGetValue(element, out DefinitionElementRule? rule) ? rule : null;

    /// <summary>The elements that an element of this name may stand in.</summary>
    public static IEnumerable<string> ParentsOf(string element) =>
        Rules.Values.Where(rule => rule.Children.Contains(element, StringComparer.Ordinal)).Select(rule => rule.Name);

    /// <summary>The elements that may have an attribute of this name.</summary>
    public static IEnumerable<string> OwnersOf(string attribute) =>
        Rules.Values.Where(rule => rule.Attributes.Contains(attribute, StringComparer.Ordinal))
            .Select(rule => rule.Name);
}
