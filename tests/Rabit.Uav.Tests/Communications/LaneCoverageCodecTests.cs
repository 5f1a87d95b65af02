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

    private protected override LaneCoverage Random(Random random) => new()
    {
        LanesKey = unchecked((uint)random.Next()),
        FirstLane = random.Next(65536),
        Parts = Enumerable.Range(0, random.Next(1, 65)).Select(_ => (ushort)random.Next(65536)).ToImmutableArray(),
    };

    private protected override void AssertEqual(LaneCoverage expected, LaneCoverage actual)
    {
        Assert.Equal(expected.LanesKey, actual.LanesKey);
        Assert.Equal(expected.FirstLane, actual.FirstLane);
        Assert.Equal(expected.Parts.AsEnumerable(), actual.Parts.AsEnumerable());
    }
}
