using System;

namespace Rabit.Mavlink.Definitions;

/// <summary>
/// Texts on the wire: UTF-8, and what is none is Latin-1, byte by byte, so that every byte can be shown. Allocates
/// nothing.
/// </summary>
internal static class Utf8Text
{
    public const int MaxBytesOfCharacter = 4;

    private const int FirstSupplementary = 0x1_0000;
    private const int LastCodePoint = 0x10_FFFF;

    /// <summary>Reads all bytes.</summary>
    /// <param name="bytes">The text.</param>
    /// <param name="characters">At least as many as there are bytes.</param>
    /// <returns>How many characters it has.</returns>
    public static int Read(ReadOnlySpan<byte> bytes, Span<char> characters)
    {
        int count = 0;
        for (int index = 0; index < bytes.Length;)
        {
            int codePoint = Next(bytes, ref index);
            if (codePoint >= FirstSupplementary)
            {
                characters[count++] = (char)(0xD800 + ((codePoint - FirstSupplementary) >> 10));
                characters[count++] = (char)(0xDC00 + ((codePoint - FirstSupplementary) & 0x3FF));
            }
            else
            {
                characters[count++] = (char)codePoint;
            }
        }

        return count;
    }

    /// <summary>Reads one character, and goes on to the next.</summary>
    public static int Next(ReadOnlySpan<byte> bytes, ref int index)
    {
        byte first = bytes[index++];
        int length = LengthOf(first);
        if (length <= 1 || index + length - 1 > bytes.Length)
            return first;
        int codePoint = first & (0x7F >> length);
        for (int i = 0; i < length - 1; i++)
        {
            if (!IsContinuation(bytes[index + i]))
                return first;
            codePoint = (codePoint << 6) | (bytes[index + i] & 0x3F);
        }

        if (codePoint < MinCodePoint(length) || codePoint is >= 0xD800 and <= 0xDFFF or > LastCodePoint)
            return first;
        index += length - 1;
        return codePoint;
    }

    /// <summary>Writes one character of a string, which may be two of its units.</summary>
    /// <param name="text">The string.</param>
    /// <param name="index">Of the character; goes on to the next.</param>
    /// <param name="bytes">At least four.</param>
    /// <returns>How many bytes it takes; 0 where it is half of a pair.</returns>
    public static int Write(string text, ref int index, Span<byte> bytes)
    {
        int codePoint = text[index];
        if (char.IsSurrogate(text[index]))
        {
            if (!char.IsHighSurrogate(text[index]) || index + 1 == text.Length || !char.IsLowSurrogate(text[index + 1]))
                return 0;
            codePoint = char.ConvertToUtf32(text[index], text[index + 1]);
            index++;
        }

        index++;
        if (codePoint < 0x80)
        {
            bytes[0] = (byte)codePoint;
            return 1;
        }

        int length = codePoint < 0x800 ? 2 : codePoint < FirstSupplementary ? 3 : 4;
        for (int i = length - 1; i > 0; i--)
        {
            bytes[i] = (byte)(0x80 | (codePoint & 0x3F));
            codePoint >>= 6;
        }

        bytes[0] = (byte)((0xF00 >> length) | codePoint);
        return length;
    }

    /// <summary>Whether a byte is one behind the first of a character.</summary>
    public static bool IsContinuation(byte value) => (value & 0xC0) == 0x80;

    /// <summary>How many bytes a character has that begins so; 0 where none does.</summary>
    public static int LengthOf(byte first) => first switch
    {
        < 0x80 => 1,
        < 0xC2 => 0,
        < 0xE0 => 2,
        < 0xF0 => 3,
        < 0xF5 => 4,
        _ => 0,
    };

    private static int MinCodePoint(int length) => length switch { 2 => 0x80, 3 => 0x800, _ => FirstSupplementary };
}
