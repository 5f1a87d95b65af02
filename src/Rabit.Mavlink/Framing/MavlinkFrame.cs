using System;
using Rabit.Mavlink.Framing;
using Rabit.Mavlink.Signing;

namespace Rabit.Mavlink;

/// <summary>
/// One MAVLink frame, checksum and signature included, as a plain value without references: it may sit in a queue or in
/// a publish-subscribe message and is copied with it (about 290 bytes; pass it by <c>in</c> where a copy is not
/// wanted). A received frame is kept bit for bit, so that <see cref="WriteTo(Span{byte})"/> writes the bytes that were
/// received: payload length as sent, flags, checksum, signature. <c>default</c> is no frame; its <see cref="Version"/>
/// is <see cref="MavlinkVersion.None"/>.
/// </summary>
/// <example>
/// <code>
/// var message = new Heartbeat { MavlinkVersion = 3 };
/// MavlinkFrame frame = MavlinkFrame.Create(message, systemId: 1, componentId: 191, sequence: 0);
/// if (frame.TryDecode(out Heartbeat heartbeat))
///     Console.WriteLine($"{frame}: {heartbeat.MavlinkVersion}, {frame.Payload.Length} payload bytes");
/// </code>
/// </example>
public unsafe partial struct MavlinkFrame
{
    /// <summary>
    /// Length of the longest possible frame on the wire, in bytes: MAVLink 2 with a full payload and a signature.
    /// </summary>
    public const int MaxWireLength = WireFormat.MaxFrameLength;

    /// <summary>Length of the longest possible payload, in bytes.</summary>
    public const int MaxPayloadLength = WireFormat.MaxPayloadLength;

    /// <summary>Length of a signature, in bytes: link id, time stamp, truncated hash.</summary>
    public const int SignatureLength = WireFormat.SignatureLength;

    private ushort _checksum;

    // Header and payload in the form of MAVLink 2, whatever the version; a start byte of zero is no frame. Of a frame
    // zero beyond the payload, always: a decoder gets the whole buffer and reads zero where the sender truncated.
    private fixed byte _wire[WireFormat.HeaderLengthV2 + WireFormat.MaxPayloadLength];

    // Zero unless the frame is signed.
    private fixed byte _signature[WireFormat.SignatureLength];

    /// <summary>The wire format it was received in or will be sent in.</summary>
    public readonly MavlinkVersion Version => _wire[0] switch
    {
        WireFormat.MagicV2 => MavlinkVersion.V2,
        WireFormat.MagicV1 => MavlinkVersion.V1,
        _ => MavlinkVersion.None,
    };

    /// <summary>Flags that a receiver must understand or drop the frame; bit 0: signed. Zero in MAVLink 1.</summary>
    public readonly byte IncompatibilityFlags => _wire[2];

    /// <summary>Flags that a receiver may ignore. Zero in MAVLink 1.</summary>
    public readonly byte CompatibilityFlags => _wire[3];

    /// <summary>The sender's frame counter, 0 to 255, then 0 again.</summary>
    public readonly byte Sequence => _wire[4];

    /// <summary>System id of the sender; 1 to 255 of a correct sender.</summary>
    public readonly byte SystemId => _wire[5];

    /// <summary>Component id of the sender; 1 to 255 of a correct sender.</summary>
    public readonly byte ComponentId => _wire[6];

    /// <summary>The message id, 0 to 16 777 215.</summary>
    public readonly int MessageId => _wire[7] | (_wire[8] << 8) | (_wire[9] << 16);

    /// <summary>Length of the payload on the wire, in bytes, 0 to 255.</summary>
    public readonly int PayloadLength => _wire[1];

    /// <summary>
    /// The checksum on the wire. A frame from a reader carries the one received, which for an unknown id could not be
    /// checked.
    /// </summary>
    public readonly ushort Checksum => _checksum;

    /// <summary>
    /// Whether 13 signature bytes belong to the frame. They are not validated here: <see cref="MavlinkVerifier"/> does
    /// that.
    /// </summary>
    public readonly bool IsSigned => (_wire[2] & WireFormat.SignedFlag) != 0;

    /// <summary>How many bytes <see cref="WriteTo(Span{byte})"/> writes; 0 for <c>default</c>.</summary>
    public readonly int WireLength => Version switch
    {
        MavlinkVersion.V1 => WireFormat.HeaderLengthV1 + PayloadLength + WireFormat.ChecksumLength,
        MavlinkVersion.V2 =>
            WireFormat.HeaderLengthV2 + PayloadLength + WireFormat.ChecksumLength
                + (IsSigned ? WireFormat.SignatureLength : 0),
        _ => 0,
    };

    /// <summary>One byte of the payload.</summary>
    /// <param name="index">
    /// 0 to 254. Zero is returned beyond <see cref="PayloadLength"/>: that is the value of a truncated byte.
    /// </param>
    /// <returns>The byte.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The index is negative or above 254.</exception>
    public readonly byte PayloadByte(int index)
    {
        if ((uint)index >= WireFormat.MaxPayloadLength)
            ThrowHelper.PayloadIndexOutOfRange(index);
        return index < _wire[1] ? _wire[WireFormat.HeaderLengthV2 + index] : (byte)0;
    }

    /// <summary>Copies the payload as it is on the wire.</summary>
    /// <param name="destination">At least <see cref="PayloadLength"/> bytes.</param>
    /// <returns>How many bytes were copied: <see cref="PayloadLength"/>.</returns>
    /// <exception cref="ArgumentException">The span is too short.</exception>
    public readonly int CopyPayloadTo(Span<byte> destination)
    {
        fixed (byte* wire = _wire)
            return Copy(new ReadOnlySpan<byte>(wire + WireFormat.HeaderLengthV2, wire[1]), destination);
    }

    /// <summary>Copies the signature: link id, 48-bit time stamp, 48 bits of the hash.</summary>
    /// <param name="destination">At least 13 bytes where the frame is signed.</param>
    /// <returns>How many bytes were copied: 13, or 0 where the frame is not signed.</returns>
    /// <exception cref="ArgumentException">The span is too short.</exception>
    public readonly int CopySignatureTo(Span<byte> destination)
    {
        fixed (byte* signature = _signature)
            return Copy(new ReadOnlySpan<byte>(signature, IsSigned ? WireFormat.SignatureLength : 0), destination);
    }

    /// <summary>Which of the sender's links the signature is for; 0 where the frame is not signed.</summary>
    public readonly byte SignatureLinkId => IsSigned ? _signature[0] : (byte)0;

    /// <summary>
    /// When the frame was signed by the sender's signing clock: tens of microseconds since 2015-01-01 UTC, 48 bits; 0
    /// where the frame is not signed.
    /// </summary>
    public readonly long SignatureTimestamp
    {
        get
        {
            if (!IsSigned)
                return 0;
            fixed (byte* signature = _signature)
                return SignatureFormat.ReadTimestamp(new ReadOnlySpan<byte>(signature, WireFormat.SignatureLength));
        }
    }

    /// <summary>Decodes the message, if the frame carries it. Allocates nothing.</summary>
    /// <typeparam name="T">The message.</typeparam>
    /// <param name="message">
    /// Its fields; what the sender truncated or its definition lacks is zero. <c>default</c> where it is another
    /// message.
    /// </param>
    /// <returns>
    /// Whether the frame carries this message. The checksum is not checked again: the reader has checked it, except for
    /// unknown ids.
    /// </returns>
    public readonly bool TryDecode<T>(out T message)
        where T : struct, IMavlinkMessage
    {
        message = default;
        if (message.MessageId != MessageId || _wire[0] == 0)
            return false;
        fixed (byte* wire = _wire)
            message.Decode(new ReadOnlySpan<byte>(wire + WireFormat.HeaderLengthV2, WireFormat.MaxPayloadLength));
        return true;
    }

    /// <summary>The system the message is for.</summary>
    /// <param name="message">
    /// The description of this frame's message; any other counts as one without the field.
    /// </param>
    /// <returns>System id; 0 is broadcast, also where the message has no such field.</returns>
    public readonly byte TargetSystem(in MavlinkMessageInfo message) => TargetAt(message, message.TargetSystemOffset);

    /// <summary>The component the message is for.</summary>
    /// <param name="message">
    /// The description of this frame's message; any other counts as one without the field.
    /// </param>
    /// <returns>Component id; 0 is every component, also where the message has no such field.</returns>
    public readonly byte TargetComponent(in MavlinkMessageInfo message)
        => TargetAt(message, message.TargetComponentOffset);

    /// <summary>Version, message id, source and sequence number, for logs and debuggers.</summary>
    /// <returns>For example <c>MAVLink 2 id 30 from 1/1 seq 17, 28 bytes</c>.</returns>
    public override readonly string ToString() => Version == MavlinkVersion.None
        ? "no frame"
        : FormattableString.Invariant(
            $"MAVLink {(int)Version} id {MessageId} from {SystemId}/{ComponentId} seq {Sequence}, {PayloadLength} bytes");

    // A reader returns 'default' for an unknown id; its offsets of zero mean nothing.
    private readonly byte TargetAt(in MavlinkMessageInfo message, short offset) =>
        offset < 0 || message.Name is null || message.Id != MessageId ? (byte)0 : PayloadByte(offset);

    private static int Copy(ReadOnlySpan<byte> source, Span<byte> destination)
    {
        if (source.Length > destination.Length)
            ThrowHelper.DestinationTooShort(source.Length, destination.Length, nameof(destination));
        source.CopyTo(destination);
        return source.Length;
    }
}
