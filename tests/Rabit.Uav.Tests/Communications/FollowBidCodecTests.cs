using System;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Bids for targets to be followed, as bytes.</summary>
public sealed class FollowBidCodecTests : VehicleMessageCodecContract<FollowBid>
{
    private protected override IVehicleMessageCodec<FollowBid> Codec { get; } = new FollowBidCodec();

    [Fact]
    public void Encode_WhatCannotBe_IsRefused()
    {
        FollowBid bid = Random(new Random(1));
        Assert.False(Fits(bid with { Finder = 0 }));
        Assert.False(Fits(bid with { Decision = 0 }));
        Assert.False(Fits(bid with { Seconds = -1 }));
        Assert.False(Fits(bid with { Seconds = double.NaN }));
    }

    private protected override FollowBid Random(Random random) => new()
    {
        Finder = (byte)random.Next(1, 256),
        Session = (ushort)random.Next(65536),
        Number = (ushort)random.Next(65536),
        Decision = (ushort)random.Next(1, 65536),
        IsOffered = random.Next(2) == 0,
        Seconds = random.Next(65536),
    };

    private protected override void AssertEqual(FollowBid expected, FollowBid actual) => Assert.Equal(expected, actual);

    private bool Fits(FollowBid bid)
        => Codec.TryEncode(bid, TimeSpan.Zero, new byte[VehicleMessageRoute.MaxLength], out _);
}
