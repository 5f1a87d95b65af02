using System;
using System.Linq;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>
/// Signs and verifies the frames of all signed links: one clock, a signer per link, a verifier per key. The
/// manager's thread only.
/// </summary>
internal sealed class LinkSigning
{
    private readonly MavlinkSigningClock _clock;
    private readonly MavlinkVerifier?[] _verifiers;
    private readonly MavlinkSigner?[] _signers;

    /// <param name="options">Checked.</param>
    /// <param name="liveLinks">How many.</param>
    /// <param name="store">Where the clock is stored; null for nowhere.</param>
    public LinkSigning(SigningOptions options, int liveLinks, IMavlinkTimestampStore? store)
    {
        _clock = store is null ? new MavlinkSigningClock() : new MavlinkSigningClock(store);
        var common = new MavlinkVerifier(options.Key, _clock, options.AcceptUnsigned);
        _verifiers = new MavlinkVerifier?[liveLinks];
        _signers = new MavlinkSigner?[liveLinks];
        for (int link = 0; link < liveLinks; link++)
        {
            bool hasOwnKey = options.LinkKeys.TryGetValue(link, out MavlinkSigningKey? key);
            if (!hasOwnKey && options.Links?.Contains(link) == false)
                continue;
            _signers[link] = new MavlinkSigner(key ?? options.Key, (byte)(options.FirstLinkId + link), _clock);
            _verifiers[link] = key is null ? common : VerifierOf(key, options);
        }
    }

    // One for all links with a key: what was received on one of them is old on the others.
    private MavlinkVerifier VerifierOf(MavlinkSigningKey key, SigningOptions options)
    {
        for (int link = 0; link < _verifiers.Length; link++)
        {
            if (_verifiers[link] is { } verifier && options.LinkKeys.TryGetValue(link, out MavlinkSigningKey? of)
                && ReferenceEquals(of, key))
                return verifier;
        }

        return new MavlinkVerifier(key, _clock, options.AcceptUnsigned);
    }

    public void Advance(DateTimeOffset utcNow, TimeSpan now) => _clock.Advance(utcNow.UtcDateTime, now);

    public void Save() => _clock.Save();

    /// <summary>Recorded logs are numbered after the live links, and never signed.</summary>
    public bool IsSigned(int link) => link < _signers.Length && _signers[link] is not null;

    public MavlinkSignatureResult Verify(in MavlinkFrame frame, int link) => _verifiers[link]!.Verify(frame, link);

    /// <summary>A frame of ours as it goes out over a link. MAVLink 1 has no signatures.</summary>
    public MavlinkFrame Sign(in MavlinkFrame frame, byte crcExtra, int link)
        => IsSigned(link) && frame.Version == MavlinkVersion.V2 ? _signers[link]!.Sign(frame, crcExtra) : frame;
}
