using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Mavlink.Generator.Model;

/// <summary>One of the eleven element types that a field can have on the wire.</summary>
/// <param name="Name">Name in the definitions, which is also what the checksum byte is computed from.</param>
/// <param name="Size">Bytes of one element.</param>
/// <param name="CSharpName">The C# keyword of the type that holds it.</param>
/// <param name="ClrName">The short CLR name that readers, writers and arrays are called by.</param>
/// <param name="Min">Smallest value; 0 for floating point, which no enum uses.</param>
/// <param name="Max">Largest value; 0 for floating point.</param>
public sealed record WireType(string Name, int Size, string CSharpName, string ClrName, decimal Min, decimal Max)
{
    private static readonly Dictionary<string, WireType> ByName = new WireType[]
    {
        new("char", 1, "byte", "Byte", byte.MinValue, byte.MaxValue),
        new("int8_t", 1, "sbyte", "SByte", sbyte.MinValue, sbyte.MaxValue),
        new("uint8_t", 1, "byte", "Byte", byte.MinValue, byte.MaxValue),
        new("int16_t", 2, "short", "Int16", short.MinValue, short.MaxValue),
        new("uint16_t", 2, "ushort", "UInt16", ushort.MinValue, ushort.MaxValue),
        new("int32_t", 4, "int", "Int32", int.MinValue, int.MaxValue),
        new("uint32_t", 4, "uint", "UInt32", uint.MinValue, uint.MaxValue),
        new("int64_t", 8, "long", "Int64", long.MinValue, long.MaxValue),
        new("uint64_t", 8, "ulong", "UInt64", ulong.MinValue, ulong.MaxValue),
        new("float", 4, "float", "Single", 0, 0),
        new("double", 8, "double", "Double", 0, 0),
    }.ToDictionary(type => type.Name, StringComparer.Ordinal);

    /// <summary>Whether it is an integer, so that it can carry an enum.</summary>
    public bool IsInteger => Max != 0;

    /// <summary>Whether it is a character, so that an array of it is a text.</summary>
    public bool IsCharacter => Name == "char";

    /// <summary>
    /// Looks a type up by its name in the definitions. <c>uint8_t_mavlink_version</c>, which only HEARTBEAT uses, is a
    /// <c>uint8_t</c> in every respect, the checksum included.
    /// </summary>
    /// <param name="name">The name without an array length.</param>
    /// <returns>The type, or null where there is none of that name.</returns>
    public static WireType? Find(string name) =>
        ByName.TryGetValue(name == "uint8_t_mavlink_version" ? "uint8_t" : name, out WireType? type) ? type : null;
}
