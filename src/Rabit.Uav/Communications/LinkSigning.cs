using System;
using System.Linq;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>
/// Signs and verifies the frames of all signed links: one key, one clock, one verifier, a signer per link. The
/// manager's thread only.
/// </summary>
internal sealed class LinkSigning
{
    private readonly MavlinkSigningClock _clock;
    private readonly MavlinkVerifier _verifier;
    private readonly MavlinkSigner?[] _signers;

    /// <param name="options">Checked.</param>
    /// <param name="liveLinks">How many.</param>
    /// <param name="store">Where the clock is stored; null for nowhere.</param>
    public LinkSigning(SigningOptions options, int liveLinks, IMavlinkTimestampStore? store)
    {
        _clock = store is null ? new MavlinkSigningClock() : new MavlinkSigningClock(store);
        _verifier = new MavlinkVerifier(options.Key, _clock, options.AcceptUnsigned);
        _signers = new MavlinkSigner?[liveLinks];
        for (int link = 0; link < liveLinks; link++)
        {
            if (options.Links is null || options.Links.Contains(link))
                _signers[link] = new MavlinkSigner(options.Key, (byte)(options.FirstLinkId + link), _clock);
        }
    }

    public void Advance(DateTimeOffset utcNow, TimeSpan now) => _clock.Advance(utcNow.UtcDateTime, now);

    public void Save() => _clock.Save();

    /// <summary>Recorded logs are numbered after the live links, and never signed.</summary>
    public bool IsSigned(int link) => link < _signers.Length && _signers[link] is not null;

    public MavlinkSignatureResult Verify(in MavlinkFrame frame, int link) => _verifier.Verify(frame, link);

    /// <summary>A frame of ours as it goes out over a link. MAVLink 1 has no signatures.</summary>
    public MavlinkFrame Sign(in MavlinkFrame frame, byte crcExtra, int link)
        => IsSigned(link) && frame.Version == MavlinkVersion.V2 ? _signers[link]!.Sign(frame, crcExtra) : frame;
}
