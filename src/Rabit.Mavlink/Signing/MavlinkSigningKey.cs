using System;
using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Text;
using Rabit.Mavlink.Framing;
using Rabit.Mavlink.Messages;
using Rabit.Mavlink.Signing;

namespace Rabit.Mavlink;

/// <summary>
/// The secret that both ends of a signed link know: 32 bytes. They leave it through <see cref="CopyTo"/> and
/// <see cref="CreateSetup"/> only; no text, exception or debugger view contains them. Safe from any thread until
/// <see cref="Dispose"/>.
/// </summary>
[DebuggerDisplay("MAVLink signing key")]
public sealed class MavlinkSigningKey : IDisposable
{
    /// <summary>Length of a key, in bytes.</summary>
    public const int Length = 32;

    // Key and longest frame but for the hash, with the padding of SHA-256.
    private const int MaxPaddedLength = 320;

    [DebuggerBrowsable(DebuggerBrowsableState.Never)]
    private readonly byte[] _secret = new byte[Length];

    private bool _isDisposed;

    /// <summary>Takes a copy of a key.</summary>
    /// <param name="secret">
    /// 32 bytes, not all of them zero: zero is what a key that was never set looks like, and what MAVLink calls "no
    /// signing".
    /// </param>
    /// <exception cref="ArgumentException">Another length, or all zero.</exception>
    public MavlinkSigningKey(ReadOnlySpan<byte> secret)
    {
        if (secret.Length != Length)
            throw new ArgumentException(
                $"A signing key has {Length} bytes, {secret.Length} were given.", nameof(secret));
        secret.CopyTo(_secret);
        if (IsZero(_secret))
            throw new ArgumentException("A signing key of zeros is no key.", nameof(secret));
    }

    /// <summary>
    /// The key that ground stations make of a pass phrase: SHA-256 of its UTF-8 bytes. No better than the phrase is
    /// long.
    /// </summary>
    /// <param name="passphrase">The phrase, exactly as given to the other end.</param>
    /// <returns>The key.</returns>
    /// <exception cref="ArgumentException">No phrase.</exception>
    public static MavlinkSigningKey FromPassphrase(string passphrase)
    {
        if (string.IsNullOrEmpty(passphrase))
            throw new ArgumentException("An empty pass phrase is no secret.", nameof(passphrase));
        int length = Encoding.UTF8.GetByteCount(passphrase);
        var buffer = new byte[Sha256.PaddedLength(length)];
        Encoding.UTF8.GetBytes(passphrase, 0, passphrase.Length, buffer, 0);
        Span<byte> secret = stackalloc byte[Length];
        Sha256.Hash(buffer, length, secret);
        buffer.AsSpan().Clear();
        var key = new MavlinkSigningKey(secret);
        secret.Clear();
        return key;
    }

    /// <summary>
    /// Whether a frame was signed with this key. Its age is not checked, so a replayed frame matches;
    /// <see cref="MavlinkVerifier"/> checks both.
    /// </summary>
    /// <param name="frame">Any frame.</param>
    /// <returns>False also where it is not signed.</returns>
    /// <exception cref="ObjectDisposedException">The key was disposed of.</exception>
    [SkipLocalsInit]
    public bool Matches(in MavlinkFrame frame)
    {
        if (!frame.IsSigned)
            return false;
        Span<byte> buffer = stackalloc byte[MaxPaddedLength];
        int length = frame.WriteTo(buffer.Slice(Length));
        ulong received = SignatureFormat.ReadHash(buffer.Slice(Length + length - WireFormat.SignatureLength));

        // Both hashes are one number: compared in one step, however much of them is right.
        return Hash(buffer, length - SignatureFormat.HashLength) == received;
    }

    /// <summary>Copies the key, for storing it where secrets are stored.</summary>
    /// <param name="destination">At least 32 bytes.</param>
    /// <exception cref="ArgumentException">The span is too short.</exception>
    /// <exception cref="ObjectDisposedException">The key was disposed of.</exception>
    public void CopyTo(Span<byte> destination)
    {
        ThrowIfDisposed();
        if (destination.Length < Length)
            ThrowHelper.DestinationTooShort(Length, destination.Length, nameof(destination));
        _secret.CopyTo(destination);
    }

    /// <summary>
    /// The message that gives this key to a vehicle. It holds the secret in clear: send it over a cable or another link
    /// that cannot be intercepted, to one system, and write it into no log. <see cref="MavlinkRouter"/> never forwards
    /// it, <see cref="TlogWriter"/> never writes it.
    /// </summary>
    /// <param name="targetSystem">The vehicle, 1 to 255.</param>
    /// <param name="targetComponent">Its component, 0 for all of them.</param>
    /// <param name="initialTimestamp">
    /// Where its signing clock begins: <see cref="MavlinkSigningClock.Timestamp"/>.
    /// </param>
    /// <returns>The message.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The system is 0, which would be a broadcast.</exception>
    /// <exception cref="ObjectDisposedException">The key was disposed of.</exception>
    public SetupSigning CreateSetup(byte targetSystem, byte targetComponent, long initialTimestamp)
    {
        ThrowIfDisposed();
        if (targetSystem == 0)
            throw new ArgumentOutOfRangeException(
                nameof(targetSystem), targetSystem, "A key is given to one system, never broadcast.");
        return new SetupSigning
        {
            TargetSystem = targetSystem,
            TargetComponent = targetComponent,
            InitialTimestamp = (ulong)initialTimestamp,
            SecretKey = new ByteArray32(_secret),
        };
    }

    /// <summary>
    /// Overwrites the key. Signing or verifying with it afterwards throws an <see cref="ObjectDisposedException"/>.
    /// </summary>
    public void Dispose()
    {
        _isDisposed = true;
        Array.Clear(_secret, 0, Length);
    }

    /// <summary>A constant text without the key.</summary>
    /// <returns><c>MAVLink signing key</c>.</returns>
    public override string ToString() => "MAVLink signing key";

    /// <summary>Signs the bytes of a frame.</summary>
    /// <param name="wire">The frame from its magic to its checksum, the flag for a signature set.</param>
    /// <param name="linkId">Which link.</param>
    /// <param name="timestamp">When.</param>
    /// <param name="signature">13 bytes.</param>
    [SkipLocalsInit]
    internal void Sign(ReadOnlySpan<byte> wire, byte linkId, long timestamp, Span<byte> signature)
    {
        Span<byte> buffer = stackalloc byte[MaxPaddedLength];
        wire.CopyTo(buffer.Slice(Length));
        Sign(buffer, wire.Length, linkId, timestamp, signature);
    }

    /// <summary>Signs a frame that is prepared for it.</summary>
    [SkipLocalsInit]
    internal void Sign(ref MavlinkFrame frame, byte linkId, long timestamp)
    {
        Span<byte> buffer = stackalloc byte[MaxPaddedLength];
        Span<byte> signature = stackalloc byte[WireFormat.SignatureLength];
        int length = frame.WriteTo(buffer.Slice(Length)) - WireFormat.SignatureLength;
        Sign(buffer, length, linkId, timestamp, signature);
        frame.SetSignature(signature);
    }

    // The frame is in the buffer already, behind the room for the key.
    private void Sign(Span<byte> buffer, int wireLength, byte linkId, long timestamp, Span<byte> signature)
    {
        SignatureFormat.WriteLinkAndTimestamp(buffer.Slice(Length + wireLength), linkId, timestamp);
        ulong hash = Hash(buffer, wireLength + SignatureFormat.LinkIdLength + SignatureFormat.TimestampLength);
        SignatureFormat.WriteLinkAndTimestamp(signature, linkId, timestamp);
        SignatureFormat.WriteHash(signature, hash);
    }

    // The key goes before the bytes in the buffer, and does not stay there.
    private ulong Hash(Span<byte> buffer, int length)
    {
        ThrowIfDisposed();
        _secret.CopyTo(buffer);
        ulong hash = Sha256.HashFirst48(buffer, Length + length);
        buffer.Slice(0, Length).Clear();
        return hash;
    }

    private void ThrowIfDisposed()
    {
        if (_isDisposed)
            throw new ObjectDisposedException(nameof(MavlinkSigningKey));
    }

    private static bool IsZero(byte[] bytes)
    {
        int all = 0;
        foreach (byte value in bytes)
            all |= value;
        return all == 0;
    }
}
