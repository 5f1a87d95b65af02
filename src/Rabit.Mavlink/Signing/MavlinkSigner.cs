using System;

namespace Rabit.Mavlink;

/// <summary>
/// Signs the frames sent by one link (MAVLink guide, "Message signing"). Allocates nothing. One thread at a time,
/// together with its clock. Set it as <see cref="MavlinkSender.Signer"/>; the receiver has a
/// <see cref="MavlinkVerifier"/>.
/// </summary>
/// <example>
/// <code>
/// using MavlinkSigningKey key = MavlinkSigningKey.FromPassphrase("a long phrase");
/// var clock = new MavlinkSigningClock();
/// clock.Advance(DateTime.UtcNow, elapsed: TimeSpan.Zero);   // again once per cycle, with the time since the start
/// var sender = new MavlinkSender(systemId: 1, componentId: 191) { Signer = new MavlinkSigner(key, linkId: 0, clock) };
/// </code>
/// </example>
public sealed class MavlinkSigner
{
    private readonly MavlinkSigningKey _key;
    private readonly MavlinkSigningClock _clock;

    /// <summary>Makes a signer. There is none without a key.</summary>
    /// <param name="key">The secret; its owner disposes of it.</param>
    /// <param name="linkId">Identifies this link among ours; receivers remember the newest time stamp per link.</param>
    /// <param name="clock">Where the time stamps come from.</param>
    /// <exception cref="ArgumentNullException">No key or no clock.</exception>
    public MavlinkSigner(MavlinkSigningKey key, byte linkId, MavlinkSigningClock clock)
    {
        _key = key ?? throw new ArgumentNullException(nameof(key));
        _clock = clock ?? throw new ArgumentNullException(nameof(clock));
        LinkId = linkId;
    }

    /// <summary>Which of our links.</summary>
    public byte LinkId { get; }

    /// <summary>Frames signed so far.</summary>
    public long Frames { get; private set; }

    /// <summary>Signs a frame of our own. Never sign what others sent: forward it unchanged.</summary>
    /// <remarks>CRC_EXTRA needs no dialect: it follows from the checksum that the frame has.</remarks>
    /// <param name="frame">The frame, MAVLink 2. A signature that it has is replaced.</param>
    /// <returns>The signed frame.</returns>
    /// <exception cref="ArgumentException">It is not a MAVLink 2 frame: MAVLink 1 has no signatures.</exception>
    /// <exception cref="InvalidOperationException">
    /// The clock was never advanced, or the checksum of the frame is wrong.
    /// </exception>
    /// <exception cref="ObjectDisposedException">The key was disposed of.</exception>
    public MavlinkFrame Sign(in MavlinkFrame frame)
    {
        CheckVersion(frame);
        return Sign(frame, frame.FindCrcExtra());
    }

    /// <summary>Signs a frame of our own. Never sign what others sent: forward it unchanged.</summary>
    /// <param name="frame">The frame, MAVLink 2. A signature that it has is replaced.</param>
    /// <param name="crcExtra">
    /// CRC_EXTRA of the message: the flag for a signature is part of the checksum. See
    /// <see cref="MavlinkMessageInfo.CrcExtra"/>.
    /// </param>
    /// <returns>The signed frame.</returns>
    /// <exception cref="ArgumentException">It is not a MAVLink 2 frame: MAVLink 1 has no signatures.</exception>
    /// <exception cref="InvalidOperationException">The clock was never advanced.</exception>
    /// <exception cref="ObjectDisposedException">The key was disposed of.</exception>
    public MavlinkFrame Sign(in MavlinkFrame frame, byte crcExtra)
    {
        CheckVersion(frame);
        MavlinkFrame signed = frame;
        signed.PrepareSignature(crcExtra);
        _key.Sign(ref signed, LinkId, _clock.Next());
        Frames++;
        return signed;
    }

    private static void CheckVersion(in MavlinkFrame frame)
    {
        if (frame.Version != MavlinkVersion.V2)
            throw new ArgumentException($"Only MAVLink 2 has signatures; this is: {frame}.", nameof(frame));
    }

    /// <summary>Signs the bytes of a frame from its magic to its checksum, the flag for a signature set.</summary>
    internal void Sign(ReadOnlySpan<byte> wire, Span<byte> signature)
    {
        _key.Sign(wire, LinkId, _clock.Next(), signature);
        Frames++;
    }
}
