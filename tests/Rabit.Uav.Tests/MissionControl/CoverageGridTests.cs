using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Which strips of an area count as seen.</summary>
public sealed class CoverageGridTests
{
    private const double HalfWidth = 7;
    private static readonly LaneSegment Strip = new(new PlanePoint(20, 10), new PlanePoint(20, 60));

    [Fact]
    public void IsSeen_NothingWasSeen_IsFalse()
        => Assert.False(Grid().IsSeen(Strip, HalfWidth, 0.02));

    [Theory]
    [InlineData(0.9, false)]
    [InlineData(0.96, false)]
    [InlineData(0.985, true)]
    [InlineData(1, true)]
    public void IsSeen_PartOfItsLength_IsSoFromTheFractionOn(double seen, bool expected)
    {
        CoverageGrid grid = Grid();
        Mark(grid, 20 - HalfWidth, 20 + HalfWidth, 10, 10 + (50 * seen));

        Assert.Equal(expected, grid.IsSeen(Strip, HalfWidth, 0.02));
    }

    [Fact]
    public void IsSeen_UnseenOnlyOutsideTheArea_IsTrue()
    {
        CoverageGrid grid = Grid();
        Mark(grid, 0, 100, 0, 80);

        Assert.True(grid.IsSeen(new LaneSegment(new PlanePoint(20, 50), new PlanePoint(20, 140)), HalfWidth, 0));
        Assert.True(grid.IsSeen(new LaneSegment(new PlanePoint(-90, -80), new PlanePoint(-90, -20)), HalfWidth, 0));
    }

    [Fact]
    public void IsSeen_RandomStrips_IsAsCountedPlaceByPlace()
    {
        int seed = Environment.TickCount;
        var random = new Random(seed);
        int seen = 0;
        for (int round = 0; round < 300; round++)
        {
            CoverageGrid grid = Grid();
            Mark(grid, 100 * random.NextDouble(), 100, 0, 80);
            var start = new PlanePoint(120 * random.NextDouble(), 100 * random.NextDouble());
            var end = new PlanePoint(120 * random.NextDouble(), 100 * random.NextDouble());
            double halfWidth = 1 + (10 * random.NextDouble());
            double fraction = 0.6 * random.NextDouble();
            var strip = new LaneSegment(start, end);
            bool expected = Count(grid, strip, halfWidth) is var (places, unseen) && unseen <= fraction * places;
            seen += expected ? 1 : 0;

            Assert.True(expected == grid.IsSeen(strip, halfWidth, fraction), $"seed {seed}, round {round}");
        }

        Assert.InRange(seen, 20, 280);
    }

    // 100 m to the north, 80 m to the east, in cells of 1 m.
    private static CoverageGrid Grid() => new(
        new PlanePolygon([new(0, 0), new(100, 0), new(100, 80), new(0, 80)]));

    private static void Mark(CoverageGrid grid, double south, double north, double west, double east)
        => grid.Mark(new(south, west), new(north, west), new(north, east), new(south, east));

    private static (int Places, int Unseen) Count(CoverageGrid grid, LaneSegment middle, double halfWidth)
    {
        var unseen = new HashSet<(double North, double East)>(grid.Unseen().Select(p => (p.North, p.East)));
        PlanePoint along = (1 / middle.Length) * (middle.End - middle.Start);
        var right = new PlanePoint(-along.East, along.North);
        (int places, int missing) = (0, 0);
        for (double at = 0.5; at < middle.Length; at++)
        {
            for (double side = 0.5 - halfWidth; side < halfWidth; side++)
            {
                PlanePoint place = middle.Start + (at * along) + (side * right);
                if (place.North is < 0 or >= 100 || place.East is < 0 or >= 80)
                    continue;
                places++;
                missing += unseen.Contains((Math.Floor(place.North) + 0.5, Math.Floor(place.East) + 0.5)) ? 1 : 0;
            }
        }

        return (places, missing);
    }
}
