using System;

namespace Rabit.Mavlink;

// The wire form: from bytes, to bytes, and from a message.
public unsafe partial struct MavlinkFrame
{
    /// <summary>Makes a frame of a message, with its checksum, unsigned. Allocates nothing.</summary>
    /// <typeparam name="T">The message.</typeparam>
    /// <param name="message">The fields to send.</param>
    /// <param name="systemId">Our system id, 1 to 255.</param>
    /// <param name="componentId">Our component id, 1 to 255.</param>
    /// <param name="sequence">Our frame counter: one more than in the frame before, modulo 256, per sender.</param>
    /// <param name="version">
    /// <see cref="MavlinkVersion.V2"/> sends extension fields and cuts trailing zeros, but keeps one byte;
    /// <see cref="MavlinkVersion.V1"/> sends exactly the fields that are no extensions (MAVLink guide, "Packet serialization").
    /// </param>
    /// <returns>The frame.</returns>
    /// <exception cref="ArgumentException">MAVLink 1 was asked for and the message id is above 255.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The version is neither 1 nor 2.</exception>
    public static MavlinkFrame Create<T>(in T message, byte systemId, byte componentId, byte sequence, MavlinkVersion version = MavlinkVersion.V2)
        where T : struct, IMavlinkMessage
    {
        T fields = message;
        int messageId = fields.MessageId;
        if (version is not (MavlinkVersion.V1 or MavlinkVersion.V2))
            ThrowHelper.NotAVersion(version);
        if (version == MavlinkVersion.V1 && messageId > WireFormat.MaxMessageIdV1)
            ThrowHelper.NotInMavlink1(typeof(T), messageId);

        MavlinkFrame frame = default;
        frame._version = (byte)version;
        frame._messageId = messageId;
        frame._systemId = systemId;
        frame._componentId = componentId;
        frame._sequence = sequence;
        frame.Encode(fields);
        frame._checksum = frame.ComputeChecksum(fields.CrcExtra);
        return frame;
    }

    /// <summary>The same message with another sequence number, with the checksum for it, unsigned. For whoever gives frames of our own their numbers.</summary>
    /// <param name="sequence">The number.</param>
    /// <param name="crcExtra">The checksum byte of the message; see <see cref="MavlinkMessageInfo.CrcExtra"/>.</param>
    /// <returns>The frame; a signature, which would not hold any more, is dropped.</returns>
    public readonly MavlinkFrame WithSequence(byte sequence, byte crcExtra)
    {
        MavlinkFrame frame = this;
        frame._sequence = sequence;
        frame._incompatibilityFlags &= unchecked((byte)~WireFormat.SignedFlag);
        for (int index = 0; index < WireFormat.SignatureLength; index++)
            frame._signature[index] = 0;
        frame._checksum = frame.ComputeChecksum(crcExtra);
        return frame;
    }

    /// <summary>Writes the frame as it goes over the wire; a received frame gives the bytes that came in.</summary>
    /// <param name="destination">At least <see cref="WireLength"/> bytes.</param>
    /// <returns>How many bytes were written: <see cref="WireLength"/>.</returns>
    /// <exception cref="ArgumentException">The span is too short.</exception>
    public readonly int WriteTo(Span<byte> destination)
    {
        int length = WireLength;
        if (destination.Length < length)
            ThrowHelper.DestinationTooShort(length, destination.Length, nameof(destination));
        if (length == 0)
            return 0;

        int position = WriteHeader(destination);
        position += CopyPayloadTo(destination.Slice(position));
        destination[position++] = (byte)_checksum;
        destination[position++] = (byte)(_checksum >> 8);
        CopySignatureTo(destination.Slice(position));
        return length;
    }

    /// <summary>Takes a frame from its bytes, which the caller has judged to be one.</summary>
    /// <param name="wire">The whole frame and nothing else.</param>
    /// <param name="frame">The frame.</param>
    internal static void FromWire(ReadOnlySpan<byte> wire, out MavlinkFrame frame)
    {
        frame = default;
        int position = frame.ReadHeader(wire);
        int payloadLength = frame._payloadLength;
        fixed (byte* payload = frame._payload)
            wire.Slice(position, payloadLength).CopyTo(new Span<byte>(payload, WireFormat.MaxPayloadLength));
        position += payloadLength;
        frame._checksum = (ushort)(wire[position] | (wire[position + 1] << 8));
        if (!frame.IsSigned)
            return;
        fixed (byte* signature = frame._signature)
            wire.Slice(position + WireFormat.ChecksumLength).CopyTo(new Span<byte>(signature, WireFormat.SignatureLength));
    }

    private int ReadHeader(ReadOnlySpan<byte> wire)
    {
        _payloadLength = wire[1];
        if (wire[0] == WireFormat.MagicV1)
        {
            _version = (byte)MavlinkVersion.V1;
            _sequence = wire[2];
            _systemId = wire[3];
            _componentId = wire[4];
            _messageId = wire[5];
            return WireFormat.HeaderLengthV1;
        }

        _version = (byte)MavlinkVersion.V2;
        _incompatibilityFlags = wire[2];
        _compatibilityFlags = wire[3];
        _sequence = wire[4];
        _systemId = wire[5];
        _componentId = wire[6];
        _messageId = wire[7] | (wire[8] << 8) | (wire[9] << 16);
        return WireFormat.HeaderLengthV2;
    }

    private readonly int WriteHeader(Span<byte> destination)
    {
        destination[1] = _payloadLength;
        if (_version == (byte)MavlinkVersion.V1)
        {
            destination[0] = WireFormat.MagicV1;
            destination[2] = _sequence;
            destination[3] = _systemId;
            destination[4] = _componentId;
            destination[5] = (byte)_messageId;
            return WireFormat.HeaderLengthV1;
        }

        destination[0] = WireFormat.MagicV2;
        destination[2] = _incompatibilityFlags;
        destination[3] = _compatibilityFlags;
        destination[4] = _sequence;
        destination[5] = _systemId;
        destination[6] = _componentId;
        destination[7] = (byte)_messageId;
        destination[8] = (byte)(_messageId >> 8);
        destination[9] = (byte)(_messageId >> 16);
        return WireFormat.HeaderLengthV2;
    }

    private void Encode<T>(in T fields)
        where T : struct, IMavlinkMessage
    {
        fixed (byte* start = _payload)
        {
            var payload = new Span<byte>(start, WireFormat.MaxPayloadLength);
            fields.Encode(payload);
            if (_version == (byte)MavlinkVersion.V1)
            {
                _payloadLength = (byte)fields.MinimumLength;
                payload.Slice(_payloadLength).Clear();
                return;
            }

            int length = fields.MaximumLength;
            while (length > 1 && payload[length - 1] == 0)
                length--;
            _payloadLength = (byte)length;
        }
    }

    private readonly ushort ComputeChecksum(byte crcExtra)
    {
        Span<byte> header = stackalloc byte[WireFormat.HeaderLengthV2];
        int headerLength = WriteHeader(header);
        ushort crc = MavlinkCrc.Add(MavlinkCrc.Initial, header.Slice(1, headerLength - 1));
        fixed (byte* payload = _payload)
            crc = MavlinkCrc.Add(crc, new ReadOnlySpan<byte>(payload, _payloadLength));
        return MavlinkCrc.Add(crc, crcExtra);
    }
}
