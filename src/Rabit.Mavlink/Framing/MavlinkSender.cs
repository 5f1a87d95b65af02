using System;
using System.Buffers;
using Rabit.Mavlink.Framing;

namespace Rabit.Mavlink;

/// <summary>
/// Sends the messages of one component: gives them their source and sequence numbers, and signs them where it has a
/// signer. Allocates nothing per frame. One per component and link, or per component where all its links carry all its
/// frames; one thread at a time.
/// </summary>
/// <example>
/// <code>
/// var sender = new MavlinkSender(systemId: 1, componentId: 191);
/// var wire = new byte[MavlinkFrame.MaxWireLength];
/// int length = sender.Write(new Heartbeat { Type = MavType.OnboardController, MavlinkVersion = 3 }, wire);
/// </code>
/// </example>
public sealed class MavlinkSender
{
    private MavlinkVersion _version = MavlinkVersion.V2;
    private MavlinkSigner? _signer;

    /// <summary>Makes a sender of MAVLink 2 frames.</summary>
    /// <param name="systemId">Our system id, 1 to 255.</param>
    /// <param name="componentId">Our component id, 1 to 255.</param>
    /// <exception cref="ArgumentOutOfRangeException">An id is 0, which means all.</exception>
    public MavlinkSender(byte systemId, byte componentId)
    {
        if (systemId == 0)
            throw new ArgumentOutOfRangeException(
                nameof(systemId), systemId, "0 means every system; ours is 1 to 255.");
        if (componentId == 0)
            throw new ArgumentOutOfRangeException(
                nameof(componentId), componentId, "0 means every component; ours is 1 to 255.");
        SystemId = systemId;
        ComponentId = componentId;
    }

    /// <summary>Our system id.</summary>
    public byte SystemId { get; }

    /// <summary>Our component id.</summary>
    public byte ComponentId { get; }

    /// <summary>The number that the next frame will have.</summary>
    public byte NextSequence { get; private set; }

    /// <summary>The wire format to send in; MAVLink 2 at first.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Neither 1 nor 2.</exception>
    /// <exception cref="InvalidOperationException">MAVLink 1 for a sender that signs.</exception>
    public MavlinkVersion Version
    {
        get => _version;
        set
        {
            if (value is not (MavlinkVersion.V1 or MavlinkVersion.V2))
                ThrowHelper.NotAVersion(value);
            Check(value, _signer);
            _version = value;
        }
    }

    /// <summary>Signs what is sent; null, as at first: nothing is signed.</summary>
    /// <exception cref="InvalidOperationException">The sender sends MAVLink 1, which has no signatures.</exception>
    public MavlinkSigner? Signer
    {
        get => _signer;
        set
        {
            Check(_version, value);
            _signer = value;
        }
    }

    /// <summary>Makes the next frame as a value, for a queue or a <see cref="MavlinkRouter"/>.</summary>
    /// <typeparam name="T">The message.</typeparam>
    /// <param name="message">The fields to send.</param>
    /// <returns>The frame.</returns>
    /// <exception cref="ArgumentException">MAVLink 1, and the message id is above 255.</exception>
    /// <exception cref="InvalidOperationException">The clock of the signer was never advanced.</exception>
    public MavlinkFrame Create<T>(in T message)
        where T : struct, IMavlinkMessage
    {
        T fields = message;
        MavlinkFrame frame = MavlinkFrame.Create(fields, SystemId, ComponentId, NextSequence, _version);
        if (_signer is not null)
            frame = _signer.Sign(frame, fields.CrcExtra);
        NextSequence++;
        return frame;
    }

    /// <summary>Writes the next frame. With room for all fields it is made in place.</summary>
    /// <typeparam name="T">The message.</typeparam>
    /// <param name="message">The fields to send.</param>
    /// <param name="destination">
    /// Room for the frame; <see cref="MavlinkFrame.MaxWireLength"/> is enough for any.
    /// </param>
    /// <returns>How many bytes were written.</returns>
    /// <exception cref="ArgumentException">
    /// The span is too short; no sequence number is used up then. Or MAVLink 1, and the message id is above 255.
    /// </exception>
    /// <exception cref="InvalidOperationException">The clock of the signer was never advanced.</exception>
    public int Write<T>(in T message, Span<byte> destination)
        where T : struct, IMavlinkMessage
    {
        T fields = message;
        FrameEncoder.CheckVersion(ref fields, _version);
        var header = new FrameHeader(_version, SystemId, ComponentId, NextSequence);
        int maxLength = header.Length + fields.MaxLength + WireFormat.ChecksumLength
            + (_signer is null ? 0 : WireFormat.SignatureLength);
        if (destination.Length < maxLength)
            return WriteCut(fields, destination);

        int length = FrameEncoder.Write(
            ref fields, header, _signer is null ? (byte)0 : WireFormat.SignedFlag, destination);
        if (_signer is not null)
        {
            _signer.Sign(destination.Slice(0, length), destination.Slice(length, WireFormat.SignatureLength));
            length += WireFormat.SignatureLength;
        }

        NextSequence++;
        return length;
    }

    /// <summary>Writes the next frame into a buffer that grows.</summary>
    /// <typeparam name="T">The message.</typeparam>
    /// <param name="message">The fields to send.</param>
    /// <param name="destination">The buffer, moved on behind the frame.</param>
    /// <returns>How many bytes were written.</returns>
    /// <exception cref="ArgumentNullException">No buffer.</exception>
    /// <exception cref="ArgumentException">MAVLink 1, and the message id is above 255.</exception>
    /// <exception cref="InvalidOperationException">The clock of the signer was never advanced.</exception>
    public int Write<T>(in T message, IBufferWriter<byte> destination)
        where T : struct, IMavlinkMessage
    {
        if (destination is null)
            throw new ArgumentNullException(nameof(destination));
        int length = Write(message, destination.GetSpan(MavlinkFrame.MaxWireLength));
        destination.Advance(length);
        return length;
    }

    // The frame may be shorter than its fields: it is made elsewhere first.
    private int WriteCut<T>(in T message, Span<byte> destination)
        where T : struct, IMavlinkMessage
    {
        Span<byte> buffer = stackalloc byte[MavlinkFrame.MaxWireLength];
        byte sequence = NextSequence;
        int length = Write(message, buffer);
        if (length > destination.Length)
        {
            NextSequence = sequence;
            ThrowHelper.DestinationTooShort(length, destination.Length, nameof(destination));
        }

        buffer.Slice(0, length).CopyTo(destination);
        return length;
    }

    private static void Check(MavlinkVersion version, MavlinkSigner? signer)
    {
        if (signer is not null && version == MavlinkVersion.V1)
            throw new InvalidOperationException("MAVLink 1 has no signatures: a sender that signs sends MAVLink 2.");
    }
}
