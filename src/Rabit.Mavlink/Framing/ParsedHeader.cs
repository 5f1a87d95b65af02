using System;

namespace Rabit.Mavlink.Framing;

/// <summary>
/// The header at one position of a byte stream, not validated. Parsing it takes the same time whatever the bytes are.
/// </summary>
internal readonly struct ParsedHeader
{
    private ParsedHeader(HeaderKind kind, int length, bool hasUnknownFlags, int messageIndex, byte crcExtra)
    {
        Kind = kind;
        Length = length;
        HasUnknownFlags = hasUnknownFlags;
        MessageIndex = messageIndex;
        CrcExtra = crcExtra;
    }

    public HeaderKind Kind { get; }

    /// <summary>
    /// Length of the whole frame on the wire, as the header states it; of the header where it is incomplete.
    /// </summary>
    public int Length { get; }

    /// <summary>Whether an incompatibility flag is set that is unknown here.</summary>
    public bool HasUnknownFlags { get; }

    /// <summary>Where the table has the description of the message; 0 where the id is not known.</summary>
    public int MessageIndex { get; }

    private byte CrcExtra { get; }

    /// <summary>Parses what begins at the first byte of the span.</summary>
    public static ParsedHeader Parse(ReadOnlySpan<byte> bytes, MessageTable messages)
    {
        if (bytes.IsEmpty)
            return new ParsedHeader(HeaderKind.Incomplete, 1, false, 0, 0);
        return bytes[0] switch
        {
            WireFormat.MagicV2 => ParseV2(bytes, messages),
            WireFormat.MagicV1 => ParseV1(bytes, messages),
            _ => default,
        };
    }

    /// <summary>Checks the checksum; only for a known message all of whose bytes have arrived.</summary>
    public bool ChecksumMatches(ReadOnlySpan<byte> bytes)
    {
        int end = bytes[1] + (bytes[0] == WireFormat.MagicV1 ? WireFormat.HeaderLengthV1 : WireFormat.HeaderLengthV2);
        ushort crc = MavlinkCrc.OfFrame(bytes.Slice(1, end - 1), CrcExtra);
        return crc == (bytes[end] | (bytes[end + 1] << 8));
    }

    private static ParsedHeader ParseV2(ReadOnlySpan<byte> bytes, MessageTable messages)
    {
        if (bytes.Length < WireFormat.HeaderLengthV2)
            return new ParsedHeader(HeaderKind.Incomplete, WireFormat.HeaderLengthV2, false, 0, 0);

        int flags = bytes[2];
        int length = WireFormat.HeaderLengthV2 + WireFormat.ChecksumLength + bytes[1]
            + (WireFormat.SignatureLength * (flags & WireFormat.SignedFlag));
        bool hasUnknownFlags = (flags & ~WireFormat.SignedFlag) != 0;
        // Any payload length will do: shorter is cut, longer comes from a newer definition with more extension fields.
        int index = messages.IndexOf(bytes[7] | (bytes[8] << 8) | (bytes[9] << 16));
        return index != 0
            ? new ParsedHeader(HeaderKind.KnownMessage, length, hasUnknownFlags, index, messages.At(index).CrcExtra)
            : new ParsedHeader(HeaderKind.UnknownMessage, length, hasUnknownFlags, 0, 0);
    }

    private static ParsedHeader ParseV1(ReadOnlySpan<byte> bytes, MessageTable messages)
    {
        if (bytes.Length < WireFormat.HeaderLengthV1)
            return new ParsedHeader(HeaderKind.Incomplete, WireFormat.HeaderLengthV1, false, 0, 0);

        int payloadLength = bytes[1];
        int length = WireFormat.HeaderLengthV1 + payloadLength + WireFormat.ChecksumLength;
        int index = messages.IndexOf(bytes[5]);
        if (index == 0)
            return new ParsedHeader(HeaderKind.UnknownMessage, length, false, 0, 0);
        // MAVLink 1 never truncates. This rejects 255 of 256 random headers, which a 1-byte id alone would accept.
        ref readonly MavlinkMessageInfo message = ref messages.At(index);
        return payloadLength >= message.MinLength && payloadLength <= message.MaxLength
            ? new ParsedHeader(HeaderKind.KnownMessage, length, false, index, message.CrcExtra)
            : default;
    }
}
