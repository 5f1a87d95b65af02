using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Tests.Shared;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.MissionControl;

public class LanePlannerTests(ITestOutputHelper output)
{
    [Fact]
    public void Lanes_Rectangle_AreOffsetByHalfASpacingAndStartNextToHome()
    {
        var area = new PlanePolygon([new(60, -80), new(60, 80), new(180, 80), new(180, -80)]);
        IReadOnlyList<LaneSegment> lanes = LanePlanner.Plan(area, 30, null, new PlanePoint(0, 10));
        Assert.Equal(4, lanes.Count);
        Assert.Equal([75.0, 105, 135, 165], lanes.Select(l => Math.Round(l.Start.North, 6)));
        Assert.Equal([80.0, -80, 80, -80], lanes.Select(l => Math.Round(l.Start.East, 6)));
        Assert.All(lanes, l => Assert.Equal(160, l.Length, 6));
    }

    [Fact]
    public void Lanes_HeadingGiven_IsKept()
    {
        var area = new PlanePolygon([new(60, -80), new(60, 80), new(180, 80), new(180, -80)]);
        IReadOnlyList<LaneSegment> lanes = LanePlanner.Plan(area, 30, 0, default);
        Assert.Equal(6, lanes.Count);
        Assert.All(lanes, l => Assert.Equal(0, Math.Sin(l.HeadingRadians), 9));
    }

    [Fact]
    public void Lanes_ConcaveArea_AreCutIntoPieces()
    {
        // A U that opens to the north, its notch wider than a spacing, with lanes across it.
        var area = new PlanePolygon(
            [new(0, 0), new(0, 200), new(150, 200), new(150, 150), new(30, 150), new(30, 50), new(150, 50),
                new(150, 0)]);
        IReadOnlyList<LaneSegment> lanes = LanePlanner.Plan(area, 30, Math.PI / 2, default);
        Assert.Equal(1 + (4 * 2), lanes.Count);
        Assert.Equal(200 + (8 * 50), lanes.Sum(l => l.Length), 6);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Lanes_RandomPolygons_CoverTheAreaInsideTheFence(int seed)
    {
        output.WriteLine($"seed {seed}");
        var random = new SeededNumbers(seed);
        for (int i = 0; i < 60; i++)
        {
            PlanePolygon area = RandomArea(random);
            double spacing = random.Uniform(8, 60);
            double? heading = random.Below(2) == 0 ? null : random.Uniform(-4, 4);
            IReadOnlyList<LaneSegment> lanes = LanePlanner.Plan(area, spacing, heading, default);
            string where = $"seed {seed}, polygon {i}, spacing {spacing}";
            PlanePolygon fence = PlanePolygon.HullOf(area.Corners.Concat([default])).Grown((spacing / 2) + 10);
            Assert.True(lanes.All(l => fence.SignedDistance(l.Start) > 0 && fence.SignedDistance(l.End) > 0), where);
            Assert.True(Covered(area, lanes, spacing, random) >= 0.99, where);
            Assert.True(
                lanes.Sum(l => l.Length) < (4 * area.Area / spacing) + (6 * Math.Sqrt(area.Area)) + (8 * spacing),
                where);
        }
    }

    [Fact]
    public void CoverageGrid_QuadsOverEverything_IsFull()
    {
        var area = new PlanePolygon([new(0, 0), new(0, 100), new(80, 120), new(90, -10)]);
        var grid = new CoverageGrid(area);
        Assert.InRange(grid.Cells * grid.CellMetres * grid.CellMetres, area.Area * 0.98, area.Area * 1.02);
        grid.Mark(new(-10, -20), new(-10, 30), new(100, 30), new(100, -20));
        double left = grid.Fraction;
        Assert.InRange(left, 0.25, 0.45);
        grid.Mark(new(-10, -20), new(-10, 30), new(100, 30), new(100, -20));
        Assert.Equal(left, grid.Fraction);
        grid.Mark(new(-10, 200), new(100, 200), new(100, 25), new(-10, 25));
        Assert.Equal(1, grid.Fraction);
        Assert.Empty(grid.Unseen());
    }

    [Fact]
    public void CoverageGrid_TurnedQuad_MarksItsAreaAndNoMore()
    {
        var area = new PlanePolygon([new(-100, -100), new(-100, 100), new(100, 100), new(100, -100)]);
        var grid = new CoverageGrid(area);
        double c = Math.Cos(0.5);
        double s = Math.Sin(0.5);
        PlanePoint At(double f, double r) => new((f * c) - (r * s), (f * s) + (r * c));
        grid.Mark(At(18, -24), At(18, 24), At(-18, 24), At(-18, -24));
        Assert.InRange(grid.SeenCells * grid.CellMetres * grid.CellMetres, 36 * 48 * 0.98, 36 * 48 * 1.02);
    }

    [Fact]
    public void CoverageGrid_MaxArea_HasNotTooManyCells()
        => Assert.InRange(
            new CoverageGrid(new PlanePolygon([new(0, 0), new(0, 2000), new(2000, 2000), new(2000, 0)])).Cells, 200_000,
            251_000);

    [Fact]
    public void GapPlanner_StripBetweenTwoLanes_IsFlownAlongItsMiddle()
    {
        IEnumerable<PlanePoint> unseen = Enumerable.Range(0, 4)
            .SelectMany(e => Enumerable.Range(0, 80).Select(n => new PlanePoint(n + 0.5, e + 20.5)));
        LaneSegment leg = Assert.Single(GapPlanner.Plan(unseen, 1, 30, 0, new PlanePoint(100, 0)));
        Assert.Equal((80, 22), (leg.Start.North, leg.Start.East));
        Assert.Equal((0, 22), (leg.End.North, leg.End.East));
    }

    [Fact]
    public void GapPlanner_SomeCellsAtTheBorder_AreLeft()
        => Assert.Empty(GapPlanner.Plan([new(0.5, 0.5), new(50.5, 0.5), new(90.5, 0.5)], 1, 20, 0, default));

    // A star about a centre: never crosses itself, concave as a rule.
    private static PlanePolygon RandomArea(SeededNumbers random)
    {
        int corners = 3 + random.Below(12);
        double size = random.Uniform(30, 400);
        var centre = new PlanePoint(random.Uniform(-300, 300), random.Uniform(-300, 300));
        double turn = random.Uniform(0, 6);
        return new PlanePolygon(Enumerable.Range(0, corners)
            .Select(
                i => centre
                    + (random.Uniform(0.3, 1) * size
                        * PlanePoint.Towards(turn + (2 * Math.PI * (i + random.Uniform(-0.3, 0.3)) / corners)))));
    }

    private static double Covered(
        PlanePolygon area, IReadOnlyList<LaneSegment> lanes, double spacing, SeededNumbers random)
    {
        int inside = 0;
        int covered = 0;
        double north = area.Corners.Max(c => c.North);
        double south = area.Corners.Min(c => c.North);
        double east = area.Corners.Max(c => c.East);
        double west = area.Corners.Min(c => c.East);
        while (inside < 400)
        {
            var p = new PlanePoint(random.Uniform(south, north), random.Uniform(west, east));
            if (!area.Contains(p))
                continue;
            inside++;
            covered += lanes.Any(l => IsBeside(l, p, spacing / 2)) ? 1 : 0;
        }

        return (double)covered / inside;
    }

    private static bool IsBeside(LaneSegment lane, PlanePoint p, double half)
    {
        PlanePoint along = (1 / lane.Length) * (lane.End - lane.Start);
        double at = (p - lane.Start).Dot(along);
        return at >= -1e-6 && at <= lane.Length + 1e-6 && Math.Abs(along.Cross(p - lane.Start)) <= half + 1e-6;
    }
}
