using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl.Group;

/// <summary>Which parts of shared lanes were seen.</summary>
public sealed class SharedLanesTests
{
    private const uint Key = 77;

    // Three lanes of 160 m to the north, 30 m apart.
    private static readonly PlanePolygon Area = new(
        [new PlanePoint(0, 0), new PlanePoint(160, 0), new PlanePoint(160, 90), new PlanePoint(0, 90)]);

    private readonly CoverageGrid _coverage = new(Area);
    private readonly SharedLanes _lanes = Lanes();

    [Fact]
    public void Take_HalfOfALaneSeen_HalfOfItIsLeft()
    {
        See(0, 80, 0, 30);
        _lanes.Take(0, _coverage);
        Assert.Equal([80, 160, 160], _lanes.MetresLeft);
    }

    [Fact]
    public void Take_StripBesideTheMiddleUnseen_PartsAreLeft()
    {
        See(0, 160, 0, 28);
        _lanes.Take(0, _coverage);
        Assert.Equal(160, _lanes.MetresLeft[0]);
    }

    [Fact]
    public void Take_WhatAnotherHasSeen_IsSeenHereToo()
    {
        See(0, 80, 0, 30);
        _lanes.Take(0, _coverage);
        var other = new CoverageGrid(Area);
        SharedLanes lanes = Lanes();
        Assert.True(lanes.Take(_lanes.ToMessage(0), other));
        Assert.Equal([80, 160, 160], lanes.MetresLeft);
        Assert.Equal(_coverage.SeenCells, other.SeenCells);
        Assert.False(other.IsUnseen(new PlanePoint(40, 15)));
        Assert.True(other.IsUnseen(new PlanePoint(100, 15)));
    }

    [Fact]
    public void Take_TheSameTwice_ChangesNothing()
    {
        See(0, 80, 0, 30);
        _lanes.Take(0, _coverage);
        int changes = _lanes.Changes;
        Assert.True(_lanes.Take(_lanes.ToMessage(0), _coverage));
        _lanes.Take(0, _coverage);
        Assert.Equal(changes, _lanes.Changes);
        Assert.Equal([80, 160, 160], _lanes.MetresLeft);
    }

    [Theory]
    [InlineData(Key + 1, 0, 3)]
    [InlineData(Key, 1, 3)]
    [InlineData(Key, 65535, 1)]
    public void Take_OfOtherLanes_IsRefused(uint key, int first, int count)
    {
        var message = new LaneCoverage
        {
            LanesKey = key,
            FirstLane = first,
            Parts = [.. Enumerable.Repeat((ushort)1, count)],
        };
        Assert.False(_lanes.Take(message, _coverage));
        Assert.Equal(0, _coverage.SeenCells);
    }

    [Fact]
    public void Skip_LegOnALane_IsLeftOutHereAndWhereItIsReceived()
    {
        See(0, 80, 30, 60);
        _lanes.Take(1, _coverage);
        _lanes.Skip(new LaneSegment(new PlanePoint(160, 45), new PlanePoint(62, 45)));
        Assert.Equal([160, 0, 160], _lanes.MetresLeft);
        Assert.Equal(8, _lanes.Skips);
        SharedLanes other = Lanes();
        var coverage = new CoverageGrid(Area);
        Assert.True(other.Take(_lanes.ToMessage(0), coverage));
        SkippedLane skipped = Assert.Single(other.TakeSkipped(_lanes.ToMessage(0)));
        Assert.Equal(new PlanePoint(80, 45), skipped.Leg.Start);
        Assert.Equal(new PlanePoint(160, 45), skipped.Leg.End);
        Assert.Equal([160, 0, 160], other.MetresLeft);
        Assert.True(coverage.IsUnseen(new PlanePoint(100, 45)));
        Assert.Empty(other.TakeSkipped(_lanes.ToMessage(0)));
        Assert.Equal(_lanes.ToMessage(0).Skipped.AsEnumerable(), other.ToMessage(0).Skipped.AsEnumerable());
    }

    [Fact]
    public void Skip_LegBesideTheLanesOrAcross_LeavesNothingOutButWhatItIsOn()
    {
        _lanes.Skip(new LaneSegment(new PlanePoint(0, 30), new PlanePoint(160, 30)));
        Assert.Equal(0, _lanes.Skips);
        Assert.Empty(_lanes.ToMessage(0).Skipped);
    }

    [Fact]
    public void Skip_PartThatIsSeenLater_CountsOnce()
    {
        _lanes.Skip(new LaneSegment(new PlanePoint(0, 15), new PlanePoint(160, 15)));
        See(0, 160, 0, 30);
        _lanes.Take(0, _coverage);
        Assert.Equal([0, 160, 160], _lanes.MetresLeft);
    }

    [Fact]
    public void TakeSkipped_OfOtherLanesOrMoreOfThem_IsNothing()
    {
        var message = new LaneCoverage { LanesKey = Key + 1, Parts = [0, 0, 0], Skipped = [1, 1, 1] };
        Assert.Empty(_lanes.TakeSkipped(message));
        Assert.Empty(_lanes.TakeSkipped(message with { LanesKey = Key, FirstLane = 1 }));
        Assert.Equal(0, _lanes.Skips);
    }

    [Fact]
    public void Of_ShareBeyondTheLanes_HasThoseThatThereAre()
        => Assert.Equal(2, _lanes.Of(new LaneShare(1, 1, 60_000)).Count);

    private void See(double south, double north, double west, double east) => _coverage.Mark(
        new PlanePoint(south, west), new PlanePoint(north, west), new PlanePoint(north, east),
        new PlanePoint(south, east));

    private static SharedLanes Lanes()
    {
        IEnumerable<LaneSegment> lanes = Enumerable.Range(0, 3)
            .Select(i => new LaneSegment(new PlanePoint(0, 15 + (30 * i)), new PlanePoint(160, 15 + (30 * i))));
        return new SharedLanes(Key, lanes.ToArray(), spacingMetres: 30);
    }
}
