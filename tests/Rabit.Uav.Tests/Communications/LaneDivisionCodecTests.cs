using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Divisions of lanes as bytes.</summary>
public sealed class LaneDivisionCodecTests : VehicleMessageCodecContract<LaneDivision>
{
    private protected override IVehicleMessageCodec<LaneDivision> Codec { get; } = new LaneDivisionCodec();

    [Fact]
    public void Encode_ImpossibleShares_AreRefused()
    {
        Assert.False(Fits());
        Assert.False(Fits(new LaneShare(0, 0, 1)));
        Assert.False(Fits(new LaneShare(1, -1, 1)));
        Assert.False(Fits(new LaneShare(1, 0, 65536)));
        Assert.False(Fits(new LaneShare(1, 0, 1), new LaneShare(1, 1, 1)));
        Assert.False(Fits([.. Enumerable.Range(1, 17).Select(i => new LaneShare((byte)i, 0, 1))]));
    }

    private protected override LaneDivision Random(Random random) => new()
    {
        LanesKey = unchecked((uint)random.Next()),
        Number = (ushort)random.Next(65536),
        Shares = Enumerable.Range(1, random.Next(1, 17))
            .Select(i => new LaneShare((byte)i, random.Next(65536), random.Next(65536))).ToImmutableArray(),
    };

    private protected override void AssertEqual(LaneDivision expected, LaneDivision actual)
    {
        Assert.Equal(expected.LanesKey, actual.LanesKey);
        Assert.Equal(expected.Number, actual.Number);
        Assert.Equal(expected.Shares.AsEnumerable(), actual.Shares.AsEnumerable());
    }

    private bool Fits(params LaneShare[] shares)
        => Codec.TryEncode(
            new LaneDivision { Shares = [.. shares] }, TimeSpan.Zero, new byte[VehicleMessageRoute.MaxLength], out _);
}
