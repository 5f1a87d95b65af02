using System;
using System.Linq;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>A whole mission over a signed link, and one with the wrong key.</summary>
public sealed class SignedFlightTests
{
    [Fact]
    public void Mission_SignedLink_IsFlownAndNothingRejected()
    {
        using MavlinkSigningKey key = MavlinkSigningKey.FromPassphrase("the same on both sides");
        using var flight = new SearchFlight(
            SearchFlight.SmallPlan(), SearchFlight.SmallWorld(), new VirtualTime(5), [], key);
        flight.Fly(TimeSpan.FromMinutes(10));

        Assert.True(flight.Mission.Phase == MissionPhase.Done, flight.Mission.Text + "\n" + flight.Log);
        MavlinkSignatureCounters signatures = flight.Link.Signatures;
        Assert.Equal(0, signatures.Rejected);
        Assert.Equal(0, signatures.UnsignedAllowed);
        Assert.InRange(signatures.Valid, 1000, flight.Link.FramesIn);
        Assert.False(flight.World.Truth.HasCrashed);
    }

    [Fact]
    public void Mission_WrongKey_NeitherSideAcceptsTheOther()
    {
        using MavlinkSigningKey key = MavlinkSigningKey.FromPassphrase("ours");
        using MavlinkSigningKey vehicleKey = MavlinkSigningKey.FromPassphrase("the vehicle's");
        using var flight = new SearchFlight(
            SearchFlight.SmallPlan(), SearchFlight.SmallWorld(), new VirtualTime(5), [], key, vehicleKey);
        flight.Fly(TimeSpan.FromMinutes(1));

        Assert.Equal(MissionPhase.WaitingForVehicle, flight.Mission.Phase);
        MavlinkSignatureCounters signatures = flight.Link.Signatures;
        Assert.Equal(0, signatures.Valid);
        Assert.InRange(signatures.BadSignatures, 50, flight.Link.FramesIn);
        Assert.Contains("with a bad signature", flight.Log, StringComparison.Ordinal);
        Assert.DoesNotContain(Secret(key), flight.Log.ToUpperInvariant(), StringComparison.Ordinal);
    }

    private static string Secret(MavlinkSigningKey key)
    {
        var bytes = new byte[MavlinkSigningKey.Length];
        key.CopyTo(bytes);
        return string.Concat(bytes.Select(b => b.ToString("X2", System.Globalization.CultureInfo.InvariantCulture)));
    }
}
