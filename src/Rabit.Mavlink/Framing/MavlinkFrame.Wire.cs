using System;
using System.Buffers;
using System.Runtime.CompilerServices;
using Rabit.Mavlink.Framing;

namespace Rabit.Mavlink;

// The wire form: from bytes, to bytes, and from a message.
public unsafe partial struct MavlinkFrame
{
    /// <summary>
    /// Makes a frame of a message, with its checksum, unsigned. Allocates nothing. <see cref="MavlinkSender"/> does
    /// this and counts.
    /// </summary>
    /// <typeparam name="T">The message.</typeparam>
    /// <param name="message">The fields to send.</param>
    /// <param name="systemId">Our system id, 1 to 255.</param>
    /// <param name="componentId">Our component id, 1 to 255.</param>
    /// <param name="sequence">Our frame counter: one more than in the frame before, modulo 256, per sender.</param>
    /// <param name="version">
    /// <see cref="MavlinkVersion.V2"/> sends extension fields and cuts trailing zeros, but keeps one byte;
    /// <see cref="MavlinkVersion.V1"/> sends exactly the fields that are no extensions (MAVLink guide, "Packet
    /// serialization").
    /// </param>
    /// <returns>The frame.</returns>
    /// <exception cref="ArgumentException">The version is MAVLink 1 and the message id is above 255.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The version is neither 1 nor 2.</exception>
    public static MavlinkFrame Create<T>(
        in T message, byte systemId, byte componentId, byte sequence, MavlinkVersion version = MavlinkVersion.V2)
        where T : struct, IMavlinkMessage
    {
        T fields = message;
        FrameEncoder.CheckVersion(ref fields, version);

        MavlinkFrame frame = default;
        var header = new FrameHeader(version, systemId, componentId, sequence);
        byte* wire = frame._wire;
        header.WriteV2(new Span<byte>(wire, WireFormat.HeaderLengthV2), fields.MessageId);
        if (version == MavlinkVersion.V1)
            wire[0] = WireFormat.MagicV1;
        wire[1] = (byte)FrameEncoder.EncodePayload(
            ref fields, version, new Span<byte>(wire + WireFormat.HeaderLengthV2, WireFormat.MaxPayloadLength));
        frame._checksum = frame.ComputeChecksum(fields.CrcExtra);
        return frame;
    }

    /// <summary>
    /// The same message with another sequence number, with the checksum for it, unsigned. For numbering frames of our
    /// own.
    /// </summary>
    /// <remarks>
    /// CRC_EXTRA needs no dialect: it follows from the checksum that the frame has, which is valid unless the id is
    /// unknown.
    /// </remarks>
    /// <param name="sequence">The number.</param>
    /// <returns>The frame; a signature, which would not be valid any more, is removed.</returns>
    /// <exception cref="InvalidOperationException">
    /// The checksum of the frame is wrong, or it is <c>default</c>.
    /// </exception>
    public readonly MavlinkFrame WithSequence(byte sequence) => WithSequence(sequence, FindCrcExtra());

    /// <summary>
    /// The same message with another sequence number, with the checksum for it, unsigned. For numbering frames of our
    /// own.
    /// </summary>
    /// <param name="sequence">The number.</param>
    /// <param name="crcExtra">CRC_EXTRA of the message; see <see cref="MavlinkMessageInfo.CrcExtra"/>.</param>
    /// <returns>The frame; a signature, which would not be valid any more, is removed.</returns>
    public readonly MavlinkFrame WithSequence(byte sequence, byte crcExtra)
    {
        MavlinkFrame frame = this;
        frame._wire[4] = sequence;
        frame.RemoveSignature(crcExtra);
        return frame;
    }

    /// <summary>
    /// The same frame unsigned, with the checksum for it: the form that the MAVLink guide ("Message signing", Logging)
    /// wants in a log.
    /// </summary>
    /// <returns>The frame.</returns>
    /// <exception cref="InvalidOperationException">The frame is signed and its checksum is wrong.</exception>
    public readonly MavlinkFrame WithoutSignature() => IsSigned ? WithoutSignature(FindCrcExtra()) : this;

    /// <summary>
    /// The same frame unsigned, with the checksum for it: the form that the MAVLink guide ("Message signing", Logging)
    /// wants in a log.
    /// </summary>
    /// <param name="crcExtra">CRC_EXTRA of the message; see <see cref="MavlinkMessageInfo.CrcExtra"/>.</param>
    /// <returns>The frame.</returns>
    public readonly MavlinkFrame WithoutSignature(byte crcExtra)
    {
        MavlinkFrame frame = this;
        if (IsSigned)
            frame.RemoveSignature(crcExtra);
        return frame;
    }

    /// <summary>Writes the frame as it is on the wire; of a received frame these are the bytes received.</summary>
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

        int position = WriteHeaderAndPayload(destination);
        destination[position] = (byte)_checksum;
        destination[position + 1] = (byte)(_checksum >> 8);
        if (IsSigned)
            CopySignatureTo(destination.Slice(position + WireFormat.ChecksumLength));
        return length;
    }

    /// <summary>Writes the frame as it is on the wire into a buffer that grows.</summary>
    /// <param name="destination">The buffer, moved on behind the frame.</param>
    /// <returns>How many bytes were written: <see cref="WireLength"/>.</returns>
    /// <exception cref="ArgumentNullException">No buffer.</exception>
    public readonly int WriteTo(IBufferWriter<byte> destination)
    {
        if (destination is null)
            throw new ArgumentNullException(nameof(destination));
        int length = WireLength;
        if (length == 0)
            return 0;
        WriteTo(destination.GetSpan(length));
        destination.Advance(length);
        return length;
    }

    /// <summary>Makes a frame of its bytes, which the caller has validated.</summary>
    /// <param name="wire">The whole frame and nothing else.</param>
    /// <param name="frame">The frame.</param>
    internal static void FromWire(ReadOnlySpan<byte> wire, out MavlinkFrame frame)
    {
        // Every byte is written below: what was in that place before does not matter.
        Unsafe.SkipInit(out frame);
        int payloadLength = wire[1];
        int end = (wire[0] == WireFormat.MagicV2 ? WireFormat.HeaderLengthV2 : WireFormat.HeaderLengthV1)
            + payloadLength;
        ReadOnlySpan<byte> bytes = wire.Slice(0, end + WireFormat.ChecksumLength);
        frame._checksum = (ushort)(bytes[end] | (bytes[end + 1] << 8));

        // Blocks of memory instead of spans: three times as fast where spans are not built in, that is on Mono.
        fixed (byte* from = bytes)
        fixed (byte* to = frame._wire)
        {
            int length = WireFormat.HeaderLengthV2 + payloadLength;
            if (from[0] == WireFormat.MagicV2)
            {
                Unsafe.CopyBlockUnaligned(to, from, (uint)length);
            }
            else
            {
                ReadHeaderV1(from, to);
                Unsafe.CopyBlockUnaligned(
                    to + WireFormat.HeaderLengthV2, from + WireFormat.HeaderLengthV1, (uint)payloadLength);
            }

            Unsafe.InitBlockUnaligned(
                to + length, 0, (uint)(WireFormat.HeaderLengthV2 + WireFormat.MaxPayloadLength - length));
        }

        fixed (byte* signature = frame._signature)
        {
            if (frame.IsSigned)
                wire.Slice(end + WireFormat.ChecksumLength)
                    .CopyTo(new Span<byte>(signature, WireFormat.SignatureLength));
            else
                Unsafe.InitBlockUnaligned(signature, 0, WireFormat.SignatureLength);
        }
    }

    /// <summary>
    /// Makes it no frame. Only what makes it one is cleared, not the payload behind it, which no member shows any more:
    /// a reader that is fed byte by byte does this for every byte.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void Clear(out MavlinkFrame frame)
    {
        Unsafe.SkipInit(out frame);
        frame._checksum = 0;
        Unsafe.WriteUnaligned(ref frame._wire[0], 0UL);
        Unsafe.WriteUnaligned(ref frame._wire[sizeof(ulong)], (ushort)0);
    }

    /// <summary>Computes CRC_EXTRA, the last byte of the checksum, from the checksum that the frame has.</summary>
    /// <exception cref="InvalidOperationException">No value of CRC_EXTRA gives that checksum: it is wrong.</exception>
    internal readonly byte FindCrcExtra()
    {
        if (_wire[0] == 0)
            throw new InvalidOperationException("The frame is empty: it has no message.");
        if (!MavlinkCrc.TryFindExtra(ChecksumBeforeExtra(), _checksum, out byte crcExtra))
            throw new InvalidOperationException(
                $"The checksum of the frame is wrong, so that its CRC_EXTRA is unknown: {this}.");
        return crcExtra;
    }

    /// <summary>Makes room for a signature: sets the flag, and the checksum with it.</summary>
    internal void PrepareSignature(byte crcExtra)
    {
        _wire[2] |= WireFormat.SignedFlag;
        _checksum = ComputeChecksum(crcExtra);
    }

    /// <summary>Puts a signature of 13 bytes into the frame.</summary>
    internal void SetSignature(ReadOnlySpan<byte> signature)
    {
        fixed (byte* to = _signature)
            signature.CopyTo(new Span<byte>(to, WireFormat.SignatureLength));
    }

    private void RemoveSignature(byte crcExtra)
    {
        _wire[2] &= unchecked((byte)~WireFormat.SignedFlag);
        for (int index = 0; index < WireFormat.SignatureLength; index++)
            _signature[index] = 0;
        _checksum = ComputeChecksum(crcExtra);
    }

    private static void ReadHeaderV1(byte* from, byte* to)
    {
        to[0] = from[0];
        to[1] = from[1];
        to[2] = 0;
        to[3] = 0;
        to[4] = from[2];
        to[5] = from[3];
        to[6] = from[4];
        to[7] = from[5];
        to[8] = 0;
        to[9] = 0;
    }

    private readonly int WriteHeaderAndPayload(Span<byte> destination)
    {
        fixed (byte* wire = _wire)
        {
            if (wire[0] == WireFormat.MagicV2)
            {
                int length = WireFormat.HeaderLengthV2 + wire[1];
                new ReadOnlySpan<byte>(wire, length).CopyTo(destination);
                return length;
            }

            destination[0] = wire[0];
            destination[1] = wire[1];
            destination[2] = wire[4];
            destination[3] = wire[5];
            destination[4] = wire[6];
            destination[5] = wire[7];
            new ReadOnlySpan<byte>(wire + WireFormat.HeaderLengthV2, wire[1])
                .CopyTo(destination.Slice(WireFormat.HeaderLengthV1));
            return WireFormat.HeaderLengthV1 + wire[1];
        }
    }

    private readonly ushort ComputeChecksum(byte crcExtra) => MavlinkCrc.Add(ChecksumBeforeExtra(), crcExtra);

    private readonly ushort ChecksumBeforeExtra()
    {
        if (_wire[0] == WireFormat.MagicV2)
        {
            fixed (byte* wire = _wire)
                return MavlinkCrc.Add(
                    MavlinkCrc.Initial, new ReadOnlySpan<byte>(wire + 1, WireFormat.HeaderLengthV2 - 1 + wire[1]));
        }

        Span<byte> bytes = stackalloc byte[WireFormat.HeaderLengthV1 + WireFormat.MaxPayloadLength];
        int length = WriteHeaderAndPayload(bytes);
        return MavlinkCrc.Add(MavlinkCrc.Initial, bytes.Slice(1, length - 1));
    }
}
