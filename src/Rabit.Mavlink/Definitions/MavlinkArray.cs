using System;
using System.ComponentModel;
using System.Globalization;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Text;

namespace Rabit.Mavlink;

/// <summary>
/// What generated arrays are made of: a struct of 64-bit words, seen as so many elements. Bytes behind the last element
/// are always zero, so that words can be compared. Only generated types of that shape may be given.
/// </summary>
[EditorBrowsable(EditorBrowsableState.Never)]
public static class MavlinkArray
{
    /// <summary>Gets one element.</summary>
    /// <typeparam name="TArray">The generated array.</typeparam>
    /// <typeparam name="T">Its element.</typeparam>
    /// <param name="array">The array.</param>
    /// <param name="length">Its length.</param>
    /// <param name="index">0 to length - 1.</param>
    /// <returns>The element.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The index is outside.</exception>
    public static T Get<TArray, T>(ref TArray array, int length, int index)
        where TArray : struct
        where T : struct
    {
        if ((uint)index >= (uint)length)
            ThrowIndex(nameof(index), length, index);
        return Unsafe.Add(ref Unsafe.As<TArray, T>(ref array), index);
    }

    /// <summary>Sets one element.</summary>
    /// <typeparam name="TArray">The generated array.</typeparam>
    /// <typeparam name="T">Its element.</typeparam>
    /// <param name="array">The array.</param>
    /// <param name="length">Its length.</param>
    /// <param name="index">0 to length - 1.</param>
    /// <param name="value">The element.</param>
    /// <exception cref="ArgumentOutOfRangeException">The index is outside.</exception>
    public static void Set<TArray, T>(ref TArray array, int length, int index, T value)
        where TArray : struct
        where T : struct
    {
        if ((uint)index >= (uint)length)
            ThrowIndex(nameof(index), length, index);
        Unsafe.Add(ref Unsafe.As<TArray, T>(ref array), index) = value;
    }

    /// <summary>Fills an array that is all zero.</summary>
    /// <typeparam name="TArray">The generated array.</typeparam>
    /// <typeparam name="T">Its element.</typeparam>
    /// <param name="array">The array.</param>
    /// <param name="length">Its length.</param>
    /// <param name="elements">At most that many.</param>
    /// <exception cref="ArgumentException">There are more.</exception>
    public static void Fill<TArray, T>(ref TArray array, int length, ReadOnlySpan<T> elements)
        where TArray : struct
        where T : struct
    {
        if (elements.Length > length)
            ThrowTooMany(nameof(elements), typeof(TArray), length, elements.Length);
        CopyBytes(
            ref BytesOf(ref array), ref MemoryMarshal.GetReference(MemoryMarshal.AsBytes(elements)),
            elements.Length * Unsafe.SizeOf<T>());
    }

    /// <summary>Copies all elements out.</summary>
    /// <typeparam name="TArray">The generated array.</typeparam>
    /// <typeparam name="T">Its element.</typeparam>
    /// <param name="array">The array.</param>
    /// <param name="length">Its length.</param>
    /// <param name="destination">Has room for all.</param>
    /// <exception cref="ArgumentException">The destination is too short.</exception>
    public static void CopyTo<TArray, T>(ref TArray array, int length, Span<T> destination)
        where TArray : struct
        where T : struct
    {
        if (destination.Length < length)
            ThrowTooShort(nameof(destination), typeof(TArray), length, destination.Length);
        CopyBytes(
            ref MemoryMarshal.GetReference(MemoryMarshal.AsBytes(destination)), ref BytesOf(ref array),
            length * Unsafe.SizeOf<T>());
    }

    /// <summary>Reads all elements from a payload.</summary>
    /// <typeparam name="TArray">The generated array.</typeparam>
    /// <typeparam name="T">Its element.</typeparam>
    /// <param name="array">The array.</param>
    /// <param name="length">Its length.</param>
    /// <param name="payload">The payload.</param>
    /// <param name="offset">Where the first element begins.</param>
    public static void Read<TArray, T>(ref TArray array, int length, ReadOnlySpan<byte> payload, int offset)
        where TArray : struct
        where T : struct
    {
        ReadOnlySpan<byte> wire = payload.Slice(offset, length * Unsafe.SizeOf<T>());
        ref byte source = ref MemoryMarshal.GetReference(wire);
        if (BitConverter.IsLittleEndian)
            CopyBytes(ref BytesOf(ref array), ref source, wire.Length);
        else
            CopySwapped(ref BytesOf(ref array), ref source, wire.Length, Unsafe.SizeOf<T>());
    }

    /// <summary>Writes all elements into a payload.</summary>
    /// <typeparam name="TArray">The generated array.</typeparam>
    /// <typeparam name="T">Its element.</typeparam>
    /// <param name="array">The array.</param>
    /// <param name="length">Its length.</param>
    /// <param name="payload">The payload.</param>
    /// <param name="offset">Where the first element begins.</param>
    public static void Write<TArray, T>(ref TArray array, int length, Span<byte> payload, int offset)
        where TArray : struct
        where T : struct
    {
        Span<byte> wire = payload.Slice(offset, length * Unsafe.SizeOf<T>());
        ref byte destination = ref MemoryMarshal.GetReference(wire);
        if (BitConverter.IsLittleEndian)
            CopyBytes(ref destination, ref BytesOf(ref array), wire.Length);
        else
            CopySwapped(ref destination, ref BytesOf(ref array), wire.Length, Unsafe.SizeOf<T>());
    }

    /// <summary>Compares all bits.</summary>
    /// <typeparam name="TArray">The generated array.</typeparam>
    /// <param name="left">One.</param>
    /// <param name="right">The other.</param>
    /// <returns>Whether all are equal.</returns>
    public static bool AreEqual<TArray>(ref TArray left, ref TArray right)
        where TArray : struct
    {
        for (int word = 0; word < Unsafe.SizeOf<TArray>() / sizeof(ulong); word++)
        {
            if (Word(ref left, word) != Word(ref right, word))
                return false;
        }

        return true;
    }

    /// <summary>Hashes all bits.</summary>
    /// <typeparam name="TArray">The generated array.</typeparam>
    /// <param name="array">The array.</param>
    /// <returns>The same number for equal arrays.</returns>
    public static int Hash<TArray>(ref TArray array)
        where TArray : struct
    {
        ulong hash = 0;
        for (int word = 0; word < Unsafe.SizeOf<TArray>() / sizeof(ulong); word++)
            // 2^64 / golden ratio: spreads the bits
            hash = unchecked(((hash << 5) | (hash >> 59)) ^ (Word(ref array, word) * 0x9E3779B97F4A7C15));
        return unchecked((int)(hash ^ (hash >> 32)));
    }

    /// <summary>Lists the elements between brackets.</summary>
    /// <typeparam name="TArray">The generated array.</typeparam>
    /// <typeparam name="T">Its element.</typeparam>
    /// <param name="array">The array.</param>
    /// <param name="length">Its length.</param>
    /// <returns>For example <c>[1, 2, 3]</c>.</returns>
    public static string Format<TArray, T>(ref TArray array, int length)
        where TArray : struct
        where T : struct, IFormattable
    {
        var text = new StringBuilder("[");
        for (int index = 0; index < length; index++)
            text.Append(index == 0 ? "" : ", ")
                .Append(Get<TArray, T>(ref array, length, index).ToString(null, CultureInfo.InvariantCulture));
        return text.Append(']').ToString();
    }

    /// <summary>Copies elements and turns each one round; what a big-endian CPU does.</summary>
    internal static void CopySwapped(ref byte destination, ref byte source, int bytes, int elementSize)
    {
        for (int start = 0; start < bytes; start += elementSize)
        {
            for (int index = 0; index < elementSize; index++)
                Unsafe.Add(ref destination, start + elementSize - 1 - index) = Unsafe.Add(ref source, start + index);
        }
    }

    private static ref byte BytesOf<TArray>(ref TArray array)
        where TArray : struct => ref Unsafe.As<TArray, byte>(ref array);

    private static ulong Word<TArray>(ref TArray array, int index)
        where TArray : struct => Unsafe.Add(ref Unsafe.As<TArray, ulong>(ref array), index);

    private static void CopyBytes(ref byte destination, ref byte source, int count)
        => Unsafe.CopyBlockUnaligned(ref destination, ref source, (uint)count);

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void ThrowIndex(string name, int length, int index) =>
        throw new ArgumentOutOfRangeException(name, index, $"The elements are 0 to {length - 1}.");

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void ThrowTooMany(string name, Type array, int length, int given) =>
        throw new ArgumentException($"{array.Name} holds {length} elements, {given} were given.", name);

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void ThrowTooShort(string name, Type array, int length, int given) =>
        throw new ArgumentException($"{array.Name} has {length} elements, the destination has room for {given}.", name);
}
