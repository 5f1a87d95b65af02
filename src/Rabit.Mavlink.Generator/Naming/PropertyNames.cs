using System;
using System.Collections.Generic;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Naming;

/// <summary>
/// Names of the properties of a message: <c>custom_mode</c> is CustomMode. A property that would be called like its
/// message is called Value (<c>AIRSPEED.airspeed</c>: <c>Airspeed.Value</c>); one that would be called like a member
/// that every message has gets Field appended; of two that would come out the same, the later one gets a 2 appended, a
/// third a 3.
/// </summary>
internal static class PropertyNames
{
    private static readonly HashSet<string> Reserved = new(StringComparer.Ordinal)
    {
        "MavlinkId", "MavlinkName", "MavlinkCrcExtra", "MavlinkMinLength", "MavlinkMaxLength", "Encode", "Decode",
        "Equals", "GetHashCode", "GetType", "ToString", "Finalize", "MemberwiseClone", "ReferenceEquals",
    };

    /// <summary>Whether a property would be called like its message, so that it is called Value.</summary>
    public static bool IsCalledLikeMessage(FieldDefinition field, string typeName)
        => PascalCase.Of(field.Name) == typeName;

    /// <summary>The C# name of each field.</summary>
    public static IReadOnlyDictionary<FieldDefinition, string> Of(MessageDefinition message, string typeName)
    {
        var names = new Dictionary<FieldDefinition, string>();
        var used = new HashSet<string>(StringComparer.Ordinal);
        foreach (FieldDefinition field in message.Fields)
        {
            string name = PascalCase.Of(field.Name);
            if (IsCalledLikeMessage(field, typeName))
                name = "Value";
            if (Reserved.Contains(name) || name == typeName)
                name += "Field";
            names[field] = Unique(name, used);
        }

        return names;
    }

    private static string Unique(string name, HashSet<string> used)
    {
        string candidate = name;
        for (int number = 2; !used.Add(candidate); number++)
            candidate = name + number;
        return candidate;
    }
}
