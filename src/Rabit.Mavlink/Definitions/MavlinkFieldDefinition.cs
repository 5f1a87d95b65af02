using System;
using System.Text;
using Rabit.Mavlink.Definitions;

namespace Rabit.Mavlink;

/// <summary>
/// A field of a message as its definition has it, and the way to its value in a frame without knowing the message at
/// compile time. Immutable, safe from any thread. What the definition does not say is null.
/// </summary>
public sealed class MavlinkFieldDefinition
{
    internal MavlinkFieldDefinition(int messageId, string name, MavlinkFieldType type, int arrayLength, int offset)
    {
        MessageId = messageId;
        Name = name;
        Type = type;
        ArrayLength = arrayLength;
        Offset = offset;
    }

    /// <summary>Id of the message it belongs to.</summary>
    public int MessageId { get; }

    /// <summary>Name as the definition writes it, for example <c>time_boot_ms</c>.</summary>
    public string Name { get; }

    /// <summary>What one element is.</summary>
    public MavlinkFieldType Type { get; }

    /// <summary>How many elements an array has; 0 for a single value.</summary>
    public int ArrayLength { get; }

    /// <summary>How many elements there are to read: 1 for a single value.</summary>
    public int Count => ArrayLength == 0 ? 1 : ArrayLength;

    /// <summary>Whether it is an array of characters: <see cref="GetText"/> reads it.</summary>
    public bool IsText => ArrayLength != 0 && Type == MavlinkFieldType.Char;

    /// <summary>Where it begins in the payload, in bytes.</summary>
    public int Offset { get; }

    /// <summary>Whether it is an extension field of MAVLink 2: zero from senders whose definition lacks it.</summary>
    public bool IsExtension { get; internal set; }

    /// <summary>Whether it distinguishes several instances of the message, as the number of a battery does.</summary>
    public bool IsInstance { get; internal set; }

    /// <summary>Unit, for example <c>degE7</c>.</summary>
    public string? Units { get; internal set; }

    /// <summary>What one count stands for, in <see cref="Units"/>, for example <c>1E-2</c>.</summary>
    public string? Multiplier { get; internal set; }

    /// <summary>
    /// The value that means "not known", for example <c>UINT16_MAX</c>; <c>[NaN:]</c> and the like for arrays.
    /// </summary>
    public string? Invalid { get; internal set; }

    /// <summary>Smallest allowed value.</summary>
    public string? MinValue { get; internal set; }

    /// <summary>Largest allowed value.</summary>
    public string? MaxValue { get; internal set; }

    /// <summary>The enum that its values are of, with all entries that the dialect has.</summary>
    public MavlinkEnumDefinition? Enum { get; internal set; }

    /// <summary>Reads one element. Allocates nothing.</summary>
    /// <param name="frame">A frame that carries the message.</param>
    /// <param name="index">0 to <see cref="Count"/> - 1.</param>
    /// <returns>The value; zero where the sender cut it.</returns>
    /// <exception cref="ArgumentException">The frame carries another message.</exception>
    /// <exception cref="ArgumentOutOfRangeException">No such element.</exception>
    public MavlinkFieldValue GetValue(in MavlinkFrame frame, int index = 0)
    {
        Check(frame);
        if ((uint)index >= (uint)Count)
            throw new ArgumentOutOfRangeException(nameof(index), index, $"{Name} has elements 0 to {Count - 1}.");
        return Read(frame, index);
    }

    /// <summary>
    /// Reads the text up to its first zero, as UTF-8; bytes that are none are the characters of the same number.
    /// </summary>
    /// <param name="frame">A frame that carries the message.</param>
    /// <returns>A new string.</returns>
    /// <exception cref="ArgumentException">The frame carries another message.</exception>
    /// <exception cref="InvalidOperationException">The field is no text.</exception>
    public string GetText(in MavlinkFrame frame)
    {
        Check(frame);
        if (!IsText)
            throw new InvalidOperationException($"{Name} is no text.");
        Span<char> characters = stackalloc char[MavlinkFrame.MaxPayloadLength];
        return characters.Slice(0, ReadText(frame, characters)).ToString();
    }

    /// <summary>
    /// Writes the value as a person reads it: names of enum entries, texts in quotes with control characters as dots,
    /// arrays in brackets.
    /// </summary>
    /// <param name="text">Where to write.</param>
    /// <param name="frame">A frame that carries the message.</param>
    /// <exception cref="ArgumentException">The frame carries another message.</exception>
    public void AppendTo(StringBuilder text, in MavlinkFrame frame)
    {
        if (text is null)
            throw new ArgumentNullException(nameof(text));
        Check(frame);
        if (IsText)
            AppendText(text, frame);
        else if (ArrayLength == 0)
            AppendElement(text, Read(frame, 0));
        else
            AppendArray(text, frame);
    }

    private void AppendText(StringBuilder text, in MavlinkFrame frame)
    {
        Span<char> characters = stackalloc char[MavlinkFrame.MaxPayloadLength];
        int length = ReadText(frame, characters);
        text.Append('"');
        for (int index = 0; index < length; index++)
            text.Append(char.IsControl(characters[index]) ? '.' : characters[index]);
        text.Append('"');
    }

    private int ReadText(in MavlinkFrame frame, Span<char> characters)
    {
        Span<byte> bytes = stackalloc byte[MavlinkFrame.MaxPayloadLength];
        int length = 0;
        while (length < ArrayLength && frame.PayloadByte(Offset + length) is not 0 and byte value)
            bytes[length++] = value;
        return Utf8Text.Read(bytes.Slice(0, length), characters);
    }

    private void AppendArray(StringBuilder text, in MavlinkFrame frame)
    {
        text.Append('[');
        for (int index = 0; index < ArrayLength; index++)
        {
            if (index != 0)
                text.Append(", ");
            AppendElement(text, Read(frame, index));
        }

        text.Append(']');
    }

    private void AppendElement(StringBuilder text, MavlinkFieldValue value)
    {
        if (Enum is null || value.IsFloatingPoint)
            value.AppendTo(text);
        else
            Enum.AppendTo(text, value.ToInt64());
    }

    private MavlinkFieldValue Read(in MavlinkFrame frame, int index)
    {
        int size = SizeOf(Type);
        int start = Offset + (index * size);
        ulong bits = 0;
        for (int place = size - 1; place >= 0; place--)
            bits = (bits << 8) | frame.PayloadByte(start + place);
        return new MavlinkFieldValue(Type, Type switch
        {
            MavlinkFieldType.Int8 => unchecked((ulong)(sbyte)bits),
            MavlinkFieldType.Int16 => unchecked((ulong)(short)bits),
            MavlinkFieldType.Int32 => unchecked((ulong)(int)bits),
            _ => bits,
        });
    }

    private static int SizeOf(MavlinkFieldType type) => type switch
    {
        MavlinkFieldType.Char or MavlinkFieldType.Int8 or MavlinkFieldType.UInt8 => 1,
        MavlinkFieldType.Int16 or MavlinkFieldType.UInt16 => 2,
        MavlinkFieldType.Int32 or MavlinkFieldType.UInt32 or MavlinkFieldType.Single => 4,
        _ => 8,
    };

    private void Check(in MavlinkFrame frame)
    {
        if (frame.MessageId != MessageId || frame.Version == MavlinkVersion.None)
            throw new ArgumentException(
                $"{Name} belongs to message {MessageId}; the frame is: {frame}.", nameof(frame));
    }
}
