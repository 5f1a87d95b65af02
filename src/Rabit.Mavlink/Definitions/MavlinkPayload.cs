using System;
using System.Buffers.Binary;
using System.ComponentModel;
using System.Runtime.CompilerServices;

namespace Rabit.Mavlink;

/// <summary>
/// How generated messages read and write single values: little endian on every CPU. Floating point goes through
/// variables, by reference, because a runtime may change the bits of a NaN that it passes by value.
/// </summary>
[EditorBrowsable(EditorBrowsableState.Never)]
public static class MavlinkPayload
{
    /// <summary>Reads a <c>uint8_t</c>.</summary>
    /// <param name="payload">The payload.</param>
    /// <param name="offset">Where the value begins.</param>
    /// <returns>The value.</returns>
    public static byte ReadByte(ReadOnlySpan<byte> payload, int offset) => payload[offset];

    /// <inheritdoc cref="ReadByte"/>
    public static sbyte ReadSByte(ReadOnlySpan<byte> payload, int offset) => unchecked((sbyte)payload[offset]);

    /// <inheritdoc cref="ReadByte"/>
    public static short ReadInt16(ReadOnlySpan<byte> payload, int offset)
        => BinaryPrimitives.ReadInt16LittleEndian(payload.Slice(offset));

    /// <inheritdoc cref="ReadByte"/>
    public static ushort ReadUInt16(ReadOnlySpan<byte> payload, int offset)
        => BinaryPrimitives.ReadUInt16LittleEndian(payload.Slice(offset));

    /// <inheritdoc cref="ReadByte"/>
    public static int ReadInt32(ReadOnlySpan<byte> payload, int offset)
        => BinaryPrimitives.ReadInt32LittleEndian(payload.Slice(offset));

    /// <inheritdoc cref="ReadByte"/>
    public static uint ReadUInt32(ReadOnlySpan<byte> payload, int offset)
        => BinaryPrimitives.ReadUInt32LittleEndian(payload.Slice(offset));

    /// <inheritdoc cref="ReadByte"/>
    public static long ReadInt64(ReadOnlySpan<byte> payload, int offset)
        => BinaryPrimitives.ReadInt64LittleEndian(payload.Slice(offset));

    /// <inheritdoc cref="ReadByte"/>
    public static ulong ReadUInt64(ReadOnlySpan<byte> payload, int offset)
        => BinaryPrimitives.ReadUInt64LittleEndian(payload.Slice(offset));

    /// <summary>Reads a <c>float</c>, bit for bit.</summary>
    /// <param name="payload">The payload.</param>
    /// <param name="offset">Where the value begins.</param>
    /// <param name="value">The value.</param>
    public static void ReadSingle(ReadOnlySpan<byte> payload, int offset, out float value)
    {
        value = 0;
        Unsafe.As<float, uint>(ref value) = ReadUInt32(payload, offset);
    }

    /// <summary>Reads a <c>double</c>, bit for bit.</summary>
    /// <param name="payload">The payload.</param>
    /// <param name="offset">Where the value begins.</param>
    /// <param name="value">The value.</param>
    public static void ReadDouble(ReadOnlySpan<byte> payload, int offset, out double value)
    {
        value = 0;
        Unsafe.As<double, ulong>(ref value) = ReadUInt64(payload, offset);
    }

    /// <summary>Writes a <c>uint8_t</c>.</summary>
    /// <param name="payload">The payload.</param>
    /// <param name="offset">Where the value begins.</param>
    /// <param name="value">The value.</param>
    public static void WriteByte(Span<byte> payload, int offset, byte value) => payload[offset] = value;

    /// <inheritdoc cref="WriteByte"/>
    public static void WriteSByte(Span<byte> payload, int offset, sbyte value)
        => payload[offset] = unchecked((byte)value);

    /// <inheritdoc cref="WriteByte"/>
    public static void WriteInt16(Span<byte> payload, int offset, short value)
        => BinaryPrimitives.WriteInt16LittleEndian(payload.Slice(offset), value);

    /// <inheritdoc cref="WriteByte"/>
    public static void WriteUInt16(Span<byte> payload, int offset, ushort value)
        => BinaryPrimitives.WriteUInt16LittleEndian(payload.Slice(offset), value);

    /// <inheritdoc cref="WriteByte"/>
    public static void WriteInt32(Span<byte> payload, int offset, int value)
        => BinaryPrimitives.WriteInt32LittleEndian(payload.Slice(offset), value);

    /// <inheritdoc cref="WriteByte"/>
    public static void WriteUInt32(Span<byte> payload, int offset, uint value)
        => BinaryPrimitives.WriteUInt32LittleEndian(payload.Slice(offset), value);

    /// <inheritdoc cref="WriteByte"/>
    public static void WriteInt64(Span<byte> payload, int offset, long value)
        => BinaryPrimitives.WriteInt64LittleEndian(payload.Slice(offset), value);

    /// <inheritdoc cref="WriteByte"/>
    public static void WriteUInt64(Span<byte> payload, int offset, ulong value)
        => BinaryPrimitives.WriteUInt64LittleEndian(payload.Slice(offset), value);

    /// <summary>Writes a <c>float</c>, bit for bit.</summary>
    /// <param name="payload">The payload.</param>
    /// <param name="offset">Where the value begins.</param>
    /// <param name="value">The value; only read.</param>
    public static void WriteSingle(Span<byte> payload, int offset, ref float value)
        => WriteUInt32(payload, offset, Unsafe.As<float, uint>(ref value));

    /// <summary>Writes a <c>double</c>, bit for bit.</summary>
    /// <param name="payload">The payload.</param>
    /// <param name="offset">Where the value begins.</param>
    /// <param name="value">The value; only read.</param>
    public static void WriteDouble(Span<byte> payload, int offset, ref double value)
        => WriteUInt64(payload, offset, Unsafe.As<double, ulong>(ref value));

    /// <summary>Refuses a payload that is shorter than the fields of its message.</summary>
    /// <param name="parameter">Name of the parameter that holds it.</param>
    /// <param name="message">Name of the message.</param>
    /// <param name="needed">Bytes of its fields.</param>
    /// <param name="given">Bytes of the payload.</param>
    /// <exception cref="ArgumentException">Always.</exception>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void ThrowTooShort(string parameter, string message, int needed, int given) =>
        throw new ArgumentException(
            $"{message} has {needed} payload bytes, the span has {given}. Fill up what the sender cut with zeros.",
            parameter);
}
