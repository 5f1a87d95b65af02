using System;
using Rabit.Geodesy;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Tests.Communications;

/// <summary>Reports of the vehicles of a group as bytes.</summary>
public sealed class GroupReportCodecTests : VehicleMessageCodecContract<GroupReport>
{
    private protected override IVehicleMessageCodec<GroupReport> Codec { get; } = new GroupReportCodec();

    [Fact]
    public void Encode_ImpossibleValues_AreRefused()
    {
        var random = new Random(32);
        Assert.False(Fits(Random(random) with { SpeedMetresPerSecond = double.NaN }));
        Assert.False(Fits(Random(random) with { SpeedMetresPerSecond = 0 }));
        Assert.False(Fits(Random(random) with { MetresLeft = double.NaN }));
        Assert.False(Fits(Random(random) with { SeenFraction = double.NaN }));
        Assert.False(Fits(Random(random) with { SeenFraction = 1.01 }));
        Assert.False(Fits(Random(random) with { SearchAltitudeAmslMetres = double.PositiveInfinity }));
        Assert.False(Fits(Random(random) with { State = (GroupMemberState)4 }));
        Assert.False(Fits(Random(random) with { LandingPlace = default }));
    }

    private protected override GroupReport Random(Random random) => new()
    {
        LanesKey = unchecked((uint)random.Next()),
        State = (GroupMemberState)random.Next(4),
        Position = Place(random),
        LandingPlace = Place(random),
        SearchAltitudeAmslMetres = (random.NextDouble() * 9000) - 400,
        SpeedMetresPerSecond = 0.5 + (random.NextDouble() * 30),
        SearchTime = TimeSpan.FromSeconds(random.Next(70_000)),
        MetresLeft = random.NextDouble() * 80_000,
        SeenFraction = random.NextDouble(),
        DivisionAuthor = (byte)random.Next(256),
        DivisionNumber = (ushort)random.Next(65536),
    };

    private protected override void AssertEqual(GroupReport expected, GroupReport actual)
    {
        Assert.Equal(expected.LanesKey, actual.LanesKey);
        Assert.Equal(expected.State, actual.State);
        AssertNear(expected.Position, actual.Position);
        AssertNear(expected.LandingPlace, actual.LandingPlace);
        Assert.Equal(expected.SearchAltitudeAmslMetres, actual.SearchAltitudeAmslMetres, 0.006);
        Assert.Equal(expected.SpeedMetresPerSecond, actual.SpeedMetresPerSecond, 0.006);
        Assert.Equal(Math.Min(65535, expected.SearchTime.TotalSeconds), actual.SearchTime.TotalSeconds, 0.6);
        Assert.Equal(Math.Min(65535, expected.MetresLeft), actual.MetresLeft, 0.6);
        Assert.InRange(actual.SeenFraction, expected.SeenFraction - 2e-5, expected.SeenFraction);
        Assert.Equal(expected.DivisionAuthor, actual.DivisionAuthor);
        Assert.Equal(expected.DivisionNumber, actual.DivisionNumber);
    }

    private bool Fits(GroupReport report) => Codec.TryEncode(report, TimeSpan.Zero, new byte[100], out _);

    private static GeodeticPosition Place(Random random) => GeodeticPosition.FromRadians(
        0.1 + (random.NextDouble() * 1.4), (random.NextDouble() - 0.5) * 2 * Math.PI,
        (random.NextDouble() * 9000) - 400);

    private static void AssertNear(GeodeticPosition expected, GeodeticPosition actual)
    {
        Assert.Equal(expected.Latitude.Radians, actual.Latitude.Radians, 1e-9);
        Assert.Equal(expected.Longitude.Radians, actual.Longitude.Radians, 1e-9);
        Assert.Equal(expected.AltitudeAmslMetres, actual.AltitudeAmslMetres, 0.006);
    }
}
