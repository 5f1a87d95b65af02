using System;

namespace Rabit.Mavlink;

/// <summary>What the header at one place in a byte stream claims. Looking at it costs the same whatever the bytes are.</summary>
internal readonly struct FrameCandidate
{
    private FrameCandidate(CandidateKind kind, int length, bool hasUnknownFlags, int messageIndex, byte crcExtra)
    {
        Kind = kind;
        Length = length;
        HasUnknownFlags = hasUnknownFlags;
        MessageIndex = messageIndex;
        CrcExtra = crcExtra;
    }

    public CandidateKind Kind { get; }

    /// <summary>Length of the whole frame on the wire, as the header claims; of the header where it is not complete.</summary>
    public int Length { get; }

    /// <summary>Whether an incompatibility flag is set that we do not know.</summary>
    public bool HasUnknownFlags { get; }

    /// <summary>Where the table has the description of the message; 0 where the id is not known.</summary>
    public int MessageIndex { get; }

    private byte CrcExtra { get; }

    /// <summary>Looks at the first byte of the span and what follows it.</summary>
    public static FrameCandidate At(ReadOnlySpan<byte> bytes, MessageTable messages)
    {
        if (bytes.IsEmpty)
            return new FrameCandidate(CandidateKind.HeaderIncomplete, 1, false, 0, 0);
        return bytes[0] switch
        {
            WireFormat.MagicV2 => AtV2(bytes, messages),
            WireFormat.MagicV1 => AtV1(bytes, messages),
            _ => default,
        };
    }

    /// <summary>Checks the checksum; only for a checkable candidate all of whose bytes are there.</summary>
    public bool ChecksumMatches(ReadOnlySpan<byte> bytes)
    {
        int end = bytes[1] + (bytes[0] == WireFormat.MagicV1 ? WireFormat.HeaderLengthV1 : WireFormat.HeaderLengthV2);
        ushort crc = MavlinkCrc.OfFrame(bytes.Slice(1, end - 1), CrcExtra);
        return crc == (bytes[end] | (bytes[end + 1] << 8));
    }

    private static FrameCandidate AtV2(ReadOnlySpan<byte> bytes, MessageTable messages)
    {
        if (bytes.Length < WireFormat.HeaderLengthV2)
            return new FrameCandidate(CandidateKind.HeaderIncomplete, WireFormat.HeaderLengthV2, false, 0, 0);

        int flags = bytes[2];
        int length = WireFormat.HeaderLengthV2 + WireFormat.ChecksumLength + bytes[1] + (WireFormat.SignatureLength * (flags & WireFormat.SignedFlag));
        bool hasUnknownFlags = (flags & ~WireFormat.SignedFlag) != 0;
        // Any payload length will do: shorter is cut, longer comes from a newer definition with more extension fields.
        int index = messages.IndexOf(bytes[7] | (bytes[8] << 8) | (bytes[9] << 16));
        return index != 0
            ? new FrameCandidate(CandidateKind.Checkable, length, hasUnknownFlags, index, messages.At(index).CrcExtra)
            : new FrameCandidate(CandidateKind.Uncheckable, length, hasUnknownFlags, 0, 0);
    }

    private static FrameCandidate AtV1(ReadOnlySpan<byte> bytes, MessageTable messages)
    {
        if (bytes.Length < WireFormat.HeaderLengthV1)
            return new FrameCandidate(CandidateKind.HeaderIncomplete, WireFormat.HeaderLengthV1, false, 0, 0);

        int payloadLength = bytes[1];
        int length = WireFormat.HeaderLengthV1 + payloadLength + WireFormat.ChecksumLength;
        int index = messages.IndexOf(bytes[5]);
        if (index == 0)
            return new FrameCandidate(CandidateKind.Uncheckable, length, false, 0, 0);
        // MAVLink 1 never truncates. This turns away 255 of 256 chance headers, which a 1-byte id alone would let through.
        ref readonly MavlinkMessageInfo message = ref messages.At(index);
        return payloadLength >= message.MinimumLength && payloadLength <= message.MaximumLength
            ? new FrameCandidate(CandidateKind.Checkable, length, false, index, message.CrcExtra)
            : default;
    }
}
