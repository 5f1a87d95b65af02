using System;
using System.Globalization;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Reading;

/// <summary>Reads one field of a message.</summary>
internal static class FieldReader
{
    public static FieldDefinition? Read(DefinitionElement element, string message, bool isExtension)
    {
        if (element.Name("name", $"A field of message {message}") is not { } name
            || ReadType(element, message, name) is not (var type, var length))
            return null;
        return new FieldDefinition(name, type, length, isExtension)
        {
            Enum = element.Attribute("enum"),
            Units = element.Attribute("units"),
            Invalid = element.Attribute("invalid"),
            Multiplier = element.Attribute("multiplier"),
            MinValue = element.Attribute("minValue"),
            MaxValue = element.Attribute("maxValue"),
            IsInstance = element.Flag("instance"),
            Description = DefinitionElement.Clean(element.Element.Value),
        };
    }

    private static (WireType Type, int Length)? ReadType(DefinitionElement element, string message, string name)
    {
        string text = element.Attribute("type") ?? "";
        int bracket = text.IndexOf('[');
        if (WireType.Find(bracket < 0 ? text : text.Substring(0, bracket)) is not { } type)
        {
            element.Fault(
                DialectFaultKind.UnknownType,
                $"Field {name} of message {message} is of type '{text}', which MAVLink does not have.");
            return null;
        }

        if (bracket < 0)
            return (type, 0);
        string length = text.Substring(bracket + 1).TrimEnd(']');
        if (text.EndsWith("]", StringComparison.Ordinal)
            && int.TryParse(length, NumberStyles.None, CultureInfo.InvariantCulture, out int elements)
            && elements is >= 1 and <= 255)
            return (type, elements);
        element.Fault(
            DialectFaultKind.MalformedNumber,
            $"Field {name} of message {message}: '{length}' in '{text}' is no array length from 1 to 255.");
        return null;
    }
}
