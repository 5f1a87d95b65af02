using System.Diagnostics.CodeAnalysis;

namespace Rabit.Mavlink;

/// <summary>What one element of a field is on the wire. All are little endian.</summary>
[SuppressMessage("Naming", "CA1720:Identifier contains type name", Justification = "They are types.")]
public enum MavlinkFieldType
{
    /// <summary><c>char</c>, one byte; an array of them is a text.</summary>
    Char,

    /// <summary><c>int8_t</c>.</summary>
    Int8,

    /// <summary><c>uint8_t</c>.</summary>
    UInt8,

    /// <summary><c>int16_t</c>.</summary>
    Int16,

    /// <summary><c>uint16_t</c>.</summary>
    UInt16,

    /// <summary><c>int32_t</c>.</summary>
    Int32,

    /// <summary><c>uint32_t</c>.</summary>
    UInt32,

    /// <summary><c>int64_t</c>.</summary>
    Int64,

    /// <summary><c>uint64_t</c>.</summary>
    UInt64,

    /// <summary><c>float</c>, 32 bits.</summary>
    Single,

    /// <summary><c>double</c>, 64 bits.</summary>
    Double,
}
