using System;

namespace Rabit.Mavlink;

/// <summary>Signs the frames that leave by one link (MAVLink guide, "Message signing"). Allocates nothing. One thread at a time, together with its clock.</summary>
public sealed class MavlinkSigner
{
    private readonly MavlinkSigningKey _key;
    private readonly MavlinkSigningClock _clock;

    /// <summary>Makes a signer. There is none without a key.</summary>
    /// <param name="key">The secret; its owner disposes of it.</param>
    /// <param name="linkId">Tells this link from our others; receivers remember the newest time stamp per link.</param>
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

    /// <summary>Signs a frame of our own. Never sign again what others sent: forward it as it is.</summary>
    /// <param name="frame">The frame, MAVLink 2. A signature that it has is replaced.</param>
    /// <param name="crcExtra">The checksum byte of the message: the flag for a signature is part of the checksum. See <see cref="MavlinkMessageInfo.CrcExtra"/>.</param>
    /// <returns>The signed frame.</returns>
    /// <exception cref="ArgumentException">It is not a MAVLink 2 frame: MAVLink 1 has no signatures.</exception>
    /// <exception cref="InvalidOperationException">The clock was never told the time.</exception>
    /// <exception cref="ObjectDisposedException">The key was disposed of.</exception>
    public MavlinkFrame Sign(in MavlinkFrame frame, byte crcExtra)
    {
        if (frame.Version != MavlinkVersion.V2)
            throw new ArgumentException($"Only MAVLink 2 has signatures; this is: {frame}.", nameof(frame));
        MavlinkFrame signed = frame;
        signed.PrepareSignature(crcExtra);
        _key.Sign(ref signed, LinkId, _clock.Next());
        Frames++;
        return signed;
    }

    /// <summary>Signs the bytes of a frame from its magic to its checksum, the flag for a signature set.</summary>
    internal void Sign(ReadOnlySpan<byte> wire, Span<byte> signature)
    {
        _key.Sign(wire, LinkId, _clock.Next(), signature);
        Frames++;
    }
}
