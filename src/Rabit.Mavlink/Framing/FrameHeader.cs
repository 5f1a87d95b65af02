using System;

namespace Rabit.Mavlink.Framing;

/// <summary>The fields of the header of a frame of our own, without those of the message.</summary>
internal readonly struct FrameHeader(MavlinkVersion version, byte systemId, byte componentId, byte sequence)
{
    public MavlinkVersion Version { get; } = version;

    /// <summary>Length of the header on the wire.</summary>
    public int Length => Version == MavlinkVersion.V1 ? WireFormat.HeaderLengthV1 : WireFormat.HeaderLengthV2;

    /// <summary>Writes a header of MAVLink 2 without flags; its payload length is still zero.</summary>
    public void WriteV2(Span<byte> destination, int messageId)
    {
        destination[9] = (byte)(messageId >> 16);
        destination[8] = (byte)(messageId >> 8);
        destination[7] = (byte)messageId;
        destination[6] = componentId;
        destination[5] = systemId;
        destination[4] = sequence;
        destination[3] = 0;
        destination[2] = 0;
        destination[1] = 0;
        destination[0] = WireFormat.MagicV2;
    }

    /// <summary>Writes a header of MAVLink 1; its payload length is still zero.</summary>
    public void WriteV1(Span<byte> destination, int messageId)
    {
        destination[5] = (byte)messageId;
        destination[4] = componentId;
        destination[3] = systemId;
        destination[2] = sequence;
        destination[1] = 0;
        destination[0] = WireFormat.MagicV1;
    }
}
