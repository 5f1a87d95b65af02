using System;
using System.ComponentModel;
using System.Runtime.CompilerServices;

namespace Rabit.Mavlink;

/// <summary>
/// What generated texts can do beyond arrays of bytes. A byte is the character of the same number (Latin-1), so that
/// every byte can be shown and nothing is lost; MAVLink itself only promises ASCII, which is the same.
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
    /// <param name="value">At most that many characters, none of them NUL or above U+00FF.</param>
    /// <exception cref="ArgumentException">The characters do not fit.</exception>
    public static void Fill<TText>(ref TText text, int capacity, string value)
        where TText : struct
    {
        if ((value ?? throw new ArgumentNullException(nameof(value))).Length > capacity)
            throw new ArgumentException(
                $"'{value}' has {value.Length} characters, {typeof(TText).Name} holds {capacity}.", nameof(value));
        for (int index = 0; index < value.Length; index++)
        {
            char character = value[index];
            if (character is '\0' or > '\u00FF')
                throw new ArgumentException(
                    $"'{value}': character {index} is U+{(int)character:X4}; a MAVLink text holds U+0001 to U+00FF.",
                    nameof(value));
            At(ref text, index) = (byte)character;
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
        Span<char> characters = stackalloc char[256];   // a payload has at most 255 bytes
        int length = Length(ref text, capacity);
        for (int index = 0; index < length; index++)
            characters[index] = (char)At(ref text, index);
        return characters.Slice(0, length).ToString();
    }

    /// <summary>Compares with a string; allocates nothing.</summary>
    /// <typeparam name="TText">The generated text.</typeparam>
    /// <param name="text">The text.</param>
    /// <param name="capacity">Its bytes.</param>
    /// <param name="value">What to compare with.</param>
    /// <returns>Whether the bytes before the first zero are the characters of the string.</returns>
    public static bool AreEqual<TText>(ref TText text, int capacity, string value)
        where TText : struct
    {
        if (value is null || value.Length != Length(ref text, capacity))
            return false;
        for (int index = 0; index < value.Length; index++)
        {
            if (At(ref text, index) != value[index])
                return false;
        }

        return true;
    }

    private static ref byte At<TText>(ref TText text, int index)
        where TText : struct => ref Unsafe.Add(ref Unsafe.As<TText, byte>(ref text), index);
}
