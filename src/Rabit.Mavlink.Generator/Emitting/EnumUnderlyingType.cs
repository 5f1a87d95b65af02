using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Mavlink.Generator.Model;

namespace Rabit.Mavlink.Generator.Emitting;

/// <summary>
/// The type under an enum: the first of int, uint, long, ulong (for bit masks uint, ulong, int, long) that holds every
/// entry and every value of every field of that enum, so that a number that has no name yet is still the number that
/// was sent.
/// </summary>
internal static class EnumUnderlyingType
{
    private static readonly WireType[] Plain = Types("int32_t", "uint32_t", "int64_t", "uint64_t");
    private static readonly WireType[] Bits = Types("uint32_t", "uint64_t", "int32_t", "int64_t");

    public static WireType Of(EnumDefinition definition, Dialect dialect)
    {
        List<WireType> fields = dialect.Messages.SelectMany(message => message.Fields)
            .Where(
                field => field.Type.IsInteger && string.Equals(field.Enum, definition.Name, StringComparison.Ordinal))
            .Select(field => field.Type).ToList();
        decimal smallest = definition.Entries.Select(entry => entry.Value).Concat(fields.Select(type => type.Min))
            .DefaultIfEmpty().Min();
        decimal largest = definition.Entries.Select(entry => entry.Value).Concat(fields.Select(type => type.Max))
            .DefaultIfEmpty().Max();
        WireType? fitting = (definition.IsBitmask ? Bits : Plain)
            .FirstOrDefault(type => type.Min <= smallest && type.Max >= largest);
        // Nothing holds both a negative number and 2^63: the bits still fit.
        return fitting ?? Plain[2];
    }

    private static WireType[] Types(params string[] names) => names.Select(name => WireType.Find(name)!).ToArray();
}
