using System;
using System.Collections.Generic;
using System.Collections.Immutable;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>Lanes divided among the vehicles of a group.</summary>
public sealed class LaneDividerTests
{
    [Fact]
    public void Divide_EqualVehicles_HaveEqualRuns()
    {
        ImmutableArray<LaneShare> shares = Divide(12, Member(1), Member(2), Member(3));
        Assert.Equal([4, 4, 4], shares.Select(s => s.Count));
        AssertComplete(shares, 12);
    }

    [Fact]
    public void Divide_OneIsTwiceAsFast_HasMoreLanes()
    {
        ImmutableArray<LaneShare> shares = Divide(12, Member(1), Member(2) with { Speed = 12 });
        Assert.True(shares[1].Count > shares[0].Count, Text(shares));
        AssertComplete(shares, 12);
    }

    [Fact]
    public void Divide_VehiclesStandAtBothSides_EachHasItsSide()
    {
        ImmutableArray<LaneShare> shares = Divide(
            12, Member(1) with { Position = new PlanePoint(0, 360) }, Member(2) with { Position = default });
        Assert.Equal(new LaneShare(2, 0, 6), shares[1]);
        Assert.Equal(new LaneShare(1, 6, 6), shares[0]);
    }

    [Fact]
    public void Divide_OneSeesTheLanesBesideItsOwn_HasMoreLanes()
    {
        ImmutableArray<LaneShare> shares = Divide(14, Member(1), Member(2) with { LanesPerPass = 2 });
        Assert.Equal([5, 9], shares.Select(s => s.Count));
        AssertComplete(shares, 14);
    }

    // It climbs and sinks for as long as two lanes take.
    [Fact]
    public void Divide_OneFliesHigher_HasFewerLanes()
    {
        ImmutableArray<LaneShare> shares = Divide(12, Member(1), Member(2) with { HeightSeconds = 116 });
        Assert.Equal([7, 5], shares.Select(s => s.Count));
    }

    [Fact]
    public void Divide_WayHomeCounts_WhoLandsFarAwayHasFewerLanes()
    {
        ImmutableArray<LaneShare> shares = Divide(
            12, Member(1) with { Landing = default(PlanePoint) },
            Member(2) with { Landing = new PlanePoint(-1200, 360) });
        Assert.True(shares[1].Count < shares[0].Count, Text(shares));
        AssertComplete(shares, 12);
    }

    // On the middle of its lane, of which half is left: it goes on there, and has no way to an end of it.
    [Fact]
    public void Divide_OneIsOnALane_GoesOnFromThere()
    {
        double[] left = [150, .. Enumerable.Repeat(300.0, 5)];
        ImmutableArray<LaneShare> shares = LaneDivider.Divide(
            Lanes(6), left,
            [
                Member(1) with { Position = new PlanePoint(150, 0) },
                Member(2) with { Position = new PlanePoint(0, 150) },
            ],
            out _);
        Assert.Equal(new LaneShare(1, 0, 3), shares[0]);
    }

    [Fact]
    public void Divide_LittleEnergy_HasWhatItCanFly()
    {
        ImmutableArray<LaneShare> shares = Divide(12, Member(1) with { Seconds = 200 }, Member(2));
        Assert.InRange(shares[0].Count, 1, 3);
        AssertComplete(shares, 12);
    }

    [Fact]
    public void Divide_EnergyOfAllIsNotEnough_AllLanesAreGivenAllTheSame()
        => AssertComplete(Divide(12, Member(1) with { Seconds = 100 }, Member(2) with { Seconds = 100 }), 12);

    [Fact]
    public void Divide_SomeLanesAreFlown_TheRestIsShared()
    {
        double[] left = [0, 0, 0, 0, 0, 0, 0, 0, 300, 300, 300, 300];
        ImmutableArray<LaneShare> shares = LaneDivider.Divide(Lanes(12), left, [Member(1), Member(2)], out _);
        AssertComplete(shares, 12);
        Assert.All(shares, s => Assert.Equal(600, left.Skip(s.First).Take(s.Count).Sum()));
    }

    [Fact]
    public void Divide_NothingIsLeft_IsComplete()
        => AssertComplete(LaneDivider.Divide(Lanes(3), [0, 0, 0], [Member(1), Member(2)], out _), 3);

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Divide_AtRandom_IsComplete(int seed)
    {
        var random = new Random(seed);
        for (int i = 0; i < 100; i++)
        {
            int count = random.Next(1, 40);
            double[] left = Enumerable.Range(0, count)
                .Select(_ => random.Next(4) == 0 ? 0 : random.NextDouble() * 300).ToArray();
            LaneDivider.Member[] members = Enumerable.Range(1, random.Next(1, 9))
                .Select(id => Member((byte)id) with
                {
                    Speed = 3 + (random.NextDouble() * 10),
                    Position = new PlanePoint(random.NextDouble() * 300, random.NextDouble() * 900),
                    Seconds = random.Next(3) == 0 ? random.NextDouble() * 400 : double.MaxValue,
                }).ToArray();
            AssertComplete(LaneDivider.Divide(Lanes(count), left, members, out _), count, $"seed {seed}, division {i}");
        }
    }

    private static ImmutableArray<LaneShare> Divide(int lanes, params LaneDivider.Member[] members)
        => LaneDivider.Divide(Lanes(lanes), Enumerable.Repeat(300.0, lanes).ToArray(), members, out _);

    private static LaneDivider.Member Member(byte id) => new(id, default, 6, double.MaxValue);

    private static LaneSegment[] Lanes(int count) => Enumerable.Range(0, count)
        .Select(i => new LaneSegment(new PlanePoint(0, 30 * i), new PlanePoint(300, 30 * i))).ToArray();

    // Each lane belongs to one vehicle.
    private static void AssertComplete(IEnumerable<LaneShare> shares, int lanes, string what = "")
    {
        IEnumerable<int> given = shares.SelectMany(s => Enumerable.Range(s.First, s.Count)).OrderBy(i => i);
        Assert.True(given.SequenceEqual(Enumerable.Range(0, lanes)), what + " " + Text(shares));
    }

    private static string Text(IEnumerable<LaneShare> shares) => string.Join("; ", shares);
}
