using System;
using Rabit.Mavlink;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The vehicle's side of a signed link: it signs all it says, and takes nothing that is not signed rightly. The
/// manager's thread only.
/// </summary>
internal sealed class VehicleSigning
{
    private readonly MavlinkSigningClock _clock = new();
    private readonly MavlinkSigner _signer;
    private readonly MavlinkVerifier _verifier;

    public VehicleSigning(MavlinkSigningKey key)
    {
        _signer = new MavlinkSigner(key, linkId: 0, _clock);
        _verifier = new MavlinkVerifier(key, _clock);
    }

    public void Advance(DateTimeOffset utcNow, TimeSpan now) => _clock.Advance(utcNow.UtcDateTime, now);

    public bool Accepts(in MavlinkFrame frame) => _verifier.Verify(frame).IsAccepted();

    public MavlinkFrame Sign(in MavlinkFrame frame)
    {
        MavlinkDialect.All.TryGetMessage(frame.MessageId, out MavlinkMessageInfo message);
        return _signer.Sign(frame, message.CrcExtra);
    }
}
