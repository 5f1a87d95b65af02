using System;
using System.ComponentModel;
using System.Runtime.CompilerServices;
using System.Text;
using Rabit.Mavlink.Definitions;

namespace Rabit.Mavlink;

/// <summary>
/// What generated texts can do beyond arrays of bytes. They are written as UTF-8, of which ASCII is part, and read so;
/// bytes that are no UTF-8 are read as the characters of the same number (Latin-1), so that every byte can be shown.
/// </summary>
[EditorBrowsable(EditorBrowsableState.Never)]
public static class MavlinkText
{
    /// <summary>Counts the bytes before the first zero.</summary>
    /// <typeparam name="TText">The generated text.</typeparam>
    /// <param name="text">The text.</param>
    /// <param name="capacity">Its bytes.</param>
    /// <returns>0 to capacity.</returns>
    public static int Length<TText>(ref TText text, int capacity)
        where TText : struct
    {
        int length = 0;
        while (length < capacity && At(ref text, length) != 0)
            length++;
        return length;
    }

    /// <summary>Fills a text that is all zero.</summary>
    /// <typeparam name="TText">The generated text.</typeparam>
    /// <param name="text">The text.</param>
    /// <param name="capacity">Its bytes.</param>
    /// <param name="value">At most that many bytes as UTF-8, no NUL and no half of a surrogate pair.</param>
    /// <exception cref="ArgumentException">The characters do not fit.</exception>
    public static void Fill<TText>(ref TText text, int capacity, string value)
        where TText : struct
    {
        if ((value ?? throw new ArgumentNullException(nameof(value))).Length > capacity)
            throw new ArgumentException(
                $"'{value}' has {value.Length} characters, {typeof(TText).Name} holds {capacity}.", nameof(value));
        Span<byte> bytes = stackalloc byte[Utf8Text.MaxBytesOfCharacter];
        int count = 0;
        for (int index = 0; index < value.Length;)
        {
            int at = index;
            int length = Utf8Text.Write(value, ref index, bytes);
            if (length == 0 || value[at] == '\0')
                throw new ArgumentException(
                    $"'{value}': character {at} is U+{(int)value[at]:X4}; a MAVLink text holds no NUL and no half of a "
                    + "surrogate pair.",
                    nameof(value));
            if (count + length > capacity)
                throw new ArgumentException(
                    $"'{value}' has {Encoding.UTF8.GetByteCount(value)} bytes as UTF-8, {typeof(TText).Name} holds "
                    + $"{capacity}.",
                    nameof(value));
            for (int i = 0; i < length; i++)
                At(ref text, count++) = bytes[i];
        }
    }

    /// <summary>Reads the text up to its first zero.</summary>
    /// <typeparam name="TText">The generated text.</typeparam>
    /// <param name="text">The text.</param>
    /// <param name="capacity">Its bytes.</param>
    /// <returns>A new string.</returns>
    public static string Read<TText>(ref TText text, int capacity)
        where TText : struct
    {
        Span<byte> bytes = stackalloc byte[256];   // a payload has at most 255 bytes
        Span<char> characters = stackalloc char[256];
        int length = CopyText(ref text, capacity, bytes);
        return characters.Slice(0, Utf8Text.Read(bytes.Slice(0, length), characters)).ToString();
    }

    /// <summary>Compares with a string; allocates nothing.</summary>
    /// <typeparam name="TText">The generated text.</typeparam>
    /// <param name="text">The text.</param>
    /// <param name="capacity">Its bytes.</param>
    /// <param name="value">What to compare with.</param>
    /// <returns>Whether the bytes before the first zero read as the string.</returns>
    public static bool AreEqual<TText>(ref TText text, int capacity, string value)
        where TText : struct
    {
        if (value is null || value.Length > capacity)
            return false;
        int length = 0;
        while (length < value.Length && value[length] < 0x80 && At(ref text, length) == value[length])
            length++;
        if (length == value.Length && (length == capacity || At(ref text, length) == 0))
            return true;
        return length < value.Length && value[length] >= 0x80 && AreEqualAsRead(ref text, capacity, value);
    }

    private static bool AreEqualAsRead<TText>(ref TText text, int capacity, string value)
        where TText : struct
    {
        Span<byte> bytes = stackalloc byte[256];
        Span<char> characters = stackalloc char[256];
        int length = CopyText(ref text, capacity, bytes);
        return characters.Slice(0, Utf8Text.Read(bytes.Slice(0, length), characters)).SequenceEqual(value.AsSpan());
    }

    private static int CopyText<TText>(ref TText text, int capacity, Span<byte> bytes)
        where TText : struct
    {
        int length = Length(ref text, capacity);
        for (int index = 0; index < length; index++)
            bytes[index] = At(ref text, index);
        return length;
    }

    private static ref byte At<TText>(ref TText text, int index)
        where TText : struct => ref Unsafe.Add(ref Unsafe.As<TText, byte>(ref text), index);
}
