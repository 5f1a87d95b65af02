using System;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>What was seen of lanes as bytes.</summary>
public sealed class LaneCoverageCodecTests : VehicleMessageCodecContract<LaneCoverage>
{
    private protected override IVehicleMessageCodec<LaneCoverage> Codec { get; } = new LaneCoverageCodec();

    private protected override LaneCoverage Random(Random random)
    {
        int lanes = random.Next(1, 65);
        var skipped = new ushort[lanes];
        for (int i = random.Next(5); i > 0; i--)
            skipped[random.Next(lanes)] = (ushort)random.Next(1, 65536);
        return new LaneCoverage
        {
            LanesKey = unchecked((uint)random.Next()),
            FirstLane = random.Next(65536),
            Parts = Enumerable.Range(0, lanes).Select(_ => (ushort)random.Next(65536)).ToImmutableArray(),
            Skipped = skipped.Any(s => s != 0) ? [.. skipped] : [],
        };
    }

    private protected override void AssertEqual(LaneCoverage expected, LaneCoverage actual)
    {
        Assert.Equal(expected.LanesKey, actual.LanesKey);
        Assert.Equal(expected.FirstLane, actual.FirstLane);
        Assert.Equal(expected.Parts.AsEnumerable(), actual.Parts.AsEnumerable());
        Assert.Equal(expected.Skipped.AsEnumerable(), actual.Skipped.AsEnumerable());
    }

    [Fact]
    public void Encode_NothingIsLeftOut_TakesNoBytesForIt()
    {
        var coverage = new LaneCoverage { Parts = [1, 2, 3], Skipped = [0, 0, 0] };
        Assert.True(Codec.TryEncode(coverage, TimeSpan.Zero, new byte[100], out int length));
        Assert.Equal(13, length);
        Assert.False(Codec.TryEncode(coverage with { Skipped = [1] }, TimeSpan.Zero, new byte[100], out _));
    }

    // Lane, parts: twice the same lane, none of the three lanes, no part.
    [Theory]
    [InlineData(1, 9, 1, 9)]
    [InlineData(0, 9, 3, 9)]
    [InlineData(0, 0, 2, 9)]
    public void Decode_LeftOutWhatCannotBe_IsRefused(byte lane, byte parts, byte lane2, byte parts2)
    {
        byte[] bytes = [1, 0, 0, 0, 0, 0, 3, 1, 0, 1, 0, 1, 0, lane, parts, 0, lane2, parts2, 0];
        Assert.False(Codec.TryDecode(bytes, Codec.Version, TimeSpan.Zero, 7, out _));
    }
}
