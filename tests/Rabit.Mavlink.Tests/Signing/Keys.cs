using System;
using System.Linq;
using System.Text.Json;
using Rabit.Mavlink.Messages;

namespace Rabit.Mavlink.Tests.Signing;

/// <summary>Keys, clocks and signed frames for the tests of signing.</summary>
internal static class Keys
{
    /// <summary>A time well after 2015, in ticks of a signing clock.</summary>
    public const long Noon = 38_557_211_493_517;

    public static MavlinkSigningKey One { get; } = Of(1);

    public static MavlinkSigningKey Of(byte seed) => new(Bytes(seed));

    public static byte[] Bytes(byte seed)
        => Enumerable.Range(0, MavlinkSigningKey.Length).Select(i => (byte)((i * 7) + seed)).ToArray();

    public static MavlinkSigningKey Of(JsonElement hex) => new(TestData.FromHex(hex.GetString()!));

    /// <summary>A clock that stands at a time.</summary>
    public static MavlinkSigningClock ClockAt(long timestamp)
    {
        var clock = new MavlinkSigningClock();
        Set(clock, timestamp);
        return clock;
    }

    public static void Set(MavlinkSigningClock clock, long timestamp)
        => clock.Advance(MavlinkSigningClock.ToUtc(timestamp), TimeSpan.Zero);

    /// <summary>A heartbeat, signed at a time.</summary>
    public static MavlinkFrame Signed(
        long timestamp, MavlinkSigningKey? key = null, byte systemId = 1, byte componentId = 1, byte linkId = 0)
    {
        var signer = new MavlinkSigner(key ?? One, linkId, ClockAt(timestamp));
        return signer.Sign(Unsigned(systemId, componentId), Heartbeat.MavlinkCrcExtra);
    }

    public static MavlinkFrame Unsigned(byte systemId = 1, byte componentId = 1) =>
        MavlinkFrame.Create(new Heartbeat { CustomMode = 4, MavlinkVersion = 3 }, systemId, componentId, 0);
}
