namespace Rabit.Mavlink.Framing;

/// <summary>Where the bytes of a frame are (MAVLink guide, "Packet serialization"), in one place.</summary>
internal static class WireFormat
{
    public const byte MagicV1 = 0xFE;
    public const byte MagicV2 = 0xFD;

    public const int HeaderLengthV1 = 6;
    public const int HeaderLengthV2 = 10;
    public const int ChecksumLength = 2;

    /// <summary>Link id, 48-bit time stamp and 48 bits of SHA-256 (MAVLink guide, "Message signing").</summary>
    public const int SignatureLength = 13;

    public const int MaxPayloadLength = 255;

    /// <summary>The longest frame: MAVLink 2, full payload, signed.</summary>
    public const int MaxFrameLength = HeaderLengthV2 + MaxPayloadLength + ChecksumLength + SignatureLength;

    public const int MaxMessageIdV1 = 0xFF;
    public const int MaxMessageIdV2 = 0xFFFFFF;

    /// <summary>
    /// The only incompatibility flag defined so far. A frame with any other must be dropped (MAVLink guide,
    /// "Incompatibility flags").
    /// </summary>
    public const byte SignedFlag = 0x01;
}
