using System;
using System.Buffers.Binary;

namespace Rabit.Mavlink.Framing;

/// <summary>
/// Puts messages on the wire (MAVLink guide, "Packet serialization"), straight into the bytes they are sent from.
/// Messages come by reference, though they are only read: a call on one that must not change would copy it first.
/// </summary>
internal static class FrameEncoder
{
    /// <summary>Refuses a message that the version cannot carry.</summary>
    public static void CheckVersion<T>(ref T fields, MavlinkVersion version)
        where T : struct, IMavlinkMessage
    {
        if (version == MavlinkVersion.V2)
            return;
        if (version != MavlinkVersion.V1)
            ThrowHelper.NotAVersion(version);
        if (fields.MessageId > WireFormat.MaxMessageIdV1)
            ThrowHelper.NotInMavlink1(typeof(T), fields.MessageId);
    }

    /// <summary>Writes the payload.</summary>
    /// <param name="fields">The message.</param>
    /// <param name="version">
    /// MAVLink 2 cuts trailing zeros but keeps one byte; MAVLink 1 sends what is no extension, in full.
    /// </param>
    /// <param name="payload">Room for all fields; zero behind those that are sent.</param>
    /// <returns>How many bytes are sent.</returns>
    public static int EncodePayload<T>(ref T fields, MavlinkVersion version, Span<byte> payload)
        where T : struct, IMavlinkMessage
    {
        fields.Encode(payload);
        int length = fields.MaxLength;
        if (version == MavlinkVersion.V1)
        {
            int sent = fields.MinLength;
            payload.Slice(sent, length - sent).Clear();
            return sent;
        }

        while (length > sizeof(ulong)
            && BinaryPrimitives.ReadUInt64LittleEndian(payload.Slice(length - sizeof(ulong))) == 0)
            length -= sizeof(ulong);
        while (length > 1 && payload[length - 1] == 0)
            length--;
        return Math.Max(length, 1);
    }

    /// <summary>Writes a whole frame but for its signature.</summary>
    /// <param name="fields">The message.</param>
    /// <param name="header">What else stands in the header.</param>
    /// <param name="flags">Incompatibility flags; zero in MAVLink 1.</param>
    /// <param name="destination">Room for the header, all fields and the checksum.</param>
    /// <returns>How many bytes were written.</returns>
    public static int Write<T>(ref T fields, in FrameHeader header, byte flags, Span<byte> destination)
        where T : struct, IMavlinkMessage
    {
        int length = header.Length;
        if (header.Version == MavlinkVersion.V1)
        {
            header.WriteV1(destination, fields.MessageId);
        }
        else
        {
            header.WriteV2(destination, fields.MessageId);
            destination[2] = flags;
        }

        int payloadLength = EncodePayload(ref fields, header.Version, destination.Slice(length));
        destination[1] = (byte)payloadLength;
        length += payloadLength;
        ushort checksum = MavlinkCrc.OfFrame(destination.Slice(1, length - 1), fields.CrcExtra);
        destination[length] = (byte)checksum;
        destination[length + 1] = (byte)(checksum >> 8);
        return length + WireFormat.ChecksumLength;
    }
}
