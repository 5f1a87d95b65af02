using System;

namespace Rabit.Mavlink;

/// <summary>What the header at one place in a byte stream claims. Looking at it costs the same whatever the bytes are.</summary>
internal readonly struct FrameCandidate
{
    private FrameCandidate(CandidateKind kind, int length, bool hasUnknownFlags, in MavlinkMessageInfo message)
    {
        Kind = kind;
        Length = length;
        HasUnknownFlags = hasUnknownFlags;
        Message = message;
    }

    public CandidateKind Kind { get; }

    /// <summary>Length of the whole frame on the wire, as the header claims.</summary>
    public int Length { get; }

    /// <summary>Whether an incompatibility flag is set that we do not know.</summary>
    public bool HasUnknownFlags { get; }

    /// <summary>The description of the message, where the id is known.</summary>
    public MavlinkMessageInfo Message { get; }

    /// <summary>Looks at the first byte of the span and what follows it.</summary>
    public static FrameCandidate At(ReadOnlySpan<byte> bytes, MavlinkDialect dialect)
    {
        if (bytes.IsEmpty)
            return new FrameCandidate(CandidateKind.HeaderIncomplete, 0, false, default);
        return bytes[0] switch
        {
            WireFormat.MagicV2 => AtV2(bytes, dialect),
            WireFormat.MagicV1 => AtV1(bytes, dialect),
            _ => default,
        };
    }

    /// <summary>Checks the checksum; only for a checkable candidate all of whose bytes are there.</summary>
    public bool ChecksumMatches(ReadOnlySpan<byte> bytes)
    {
        int end = bytes[1] + (bytes[0] == WireFormat.MagicV1 ? WireFormat.HeaderLengthV1 : WireFormat.HeaderLengthV2);
        ushort crc = MavlinkCrc.Add(MavlinkCrc.Initial, bytes.Slice(1, end - 1));
        crc = MavlinkCrc.Add(crc, Message.CrcExtra);
        return crc == (bytes[end] | (bytes[end + 1] << 8));
    }

    private static FrameCandidate AtV2(ReadOnlySpan<byte> bytes, MavlinkDialect dialect)
    {
        if (bytes.Length < WireFormat.HeaderLengthV2)
            return new FrameCandidate(CandidateKind.HeaderIncomplete, 0, false, default);

        int flags = bytes[2];
        int length = WireFormat.HeaderLengthV2 + bytes[1] + WireFormat.ChecksumLength
            + ((flags & WireFormat.SignedFlag) != 0 ? WireFormat.SignatureLength : 0);
        int messageId = bytes[7] | (bytes[8] << 8) | (bytes[9] << 16);
        bool hasUnknownFlags = (flags & ~WireFormat.SignedFlag) != 0;
        // Any payload length will do: shorter is cut, longer comes from a newer definition with more extension fields.
        return dialect.TryGetMessage(messageId, out MavlinkMessageInfo message)
            ? new FrameCandidate(CandidateKind.Checkable, length, hasUnknownFlags, message)
            : new FrameCandidate(CandidateKind.Uncheckable, length, hasUnknownFlags, default);
    }

    private static FrameCandidate AtV1(ReadOnlySpan<byte> bytes, MavlinkDialect dialect)
    {
        if (bytes.Length < WireFormat.HeaderLengthV1)
            return new FrameCandidate(CandidateKind.HeaderIncomplete, 0, false, default);

        int payloadLength = bytes[1];
        int length = WireFormat.HeaderLengthV1 + payloadLength + WireFormat.ChecksumLength;
        if (!dialect.TryGetMessage(bytes[5], out MavlinkMessageInfo message))
            return new FrameCandidate(CandidateKind.Uncheckable, length, false, default);
        // MAVLink 1 never truncates. This turns away 255 of 256 chance headers, which a 1-byte id alone would let through.
        return payloadLength >= message.MinimumLength && payloadLength <= message.MaximumLength
            ? new FrameCandidate(CandidateKind.Checkable, length, false, message)
            : default;
    }
}
