using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Tests.Shared;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>
/// The planned way over the areas of tests/data/autonomy/search-areas.json. Covered is what is within half a sweep of
/// the way, straight transfers included.
/// </summary>
public class SearchPlannerTests(ITestOutputHelper output)
{
    private const double ClearanceMetres = 10;
    private const double MaxRandomRatio = 1.35;

    // Decision 26 says why no way inside these two is as short as the limits of the others.
    private const int Comb = 11;
    private const double MaxOfComb = 2.45;
    private const int Wedge = 27;
    private const double MaxOfWedge = 1.45;

    [Fact]
    public void Plan_OneAreaWithHoles_IsCoveredByAShortWay()
    {
        PlannedArea planned = PlannedArea.All().Single(a => a.Id == 24);
        Assert.Equal("holes", planned.Kind);
        Check(planned);
        Assert.InRange(planned.Ratio, 0.9, 1.3);
    }

    [Fact, Trait("Category", "Long")]
    public void Plan_AllAreas_AreCoveredByShortWays()
    {
        List<PlannedArea> all = PlannedArea.All().ToList();
        Assert.Equal(40, all.Count);
        all.ForEach(Check);
        SearchPlanningDocument.Update(all);
        foreach (IGrouping<string, PlannedArea> kind in all.GroupBy(a => a.Kind))
        {
            double mean = kind.Where(a => a.Id != Comb).Average(a => a.Ratio);
            output.WriteLine(FormattableString.Invariant($"{kind.Key}: mean {mean:0.000}"));
            Assert.InRange(mean, 0.9, kind.Key switch { "convex" => 1.18, "concave" => 1.22, _ => 1.25 });
        }

        Assert.All(
            all, a => Assert.InRange(
                a.Ratio, 0.9,
                a.Id switch { Comb => MaxOfComb, Wedge => MaxOfWedge, _ => a.Kind == "sliver" ? 1.3 : 1.35 }));
    }

    [Fact, Trait("Category", "Long")]
    public void Plan_RandomAreasWithHoles_AreCovered()
    {
        var random = new SeededNumbers(40);
        for (int i = 0; i < 40; i++)
        {
            output.WriteLine($"seed 40, area {i}");
            PlanePolygon outer = Star(random, default, random.Uniform(200, 500), 4 + random.Below(8));
            PlanePolygon hole = Star(random, new PlanePoint(10, 10), random.Uniform(15, 50), 3 + random.Below(5));
            bool isInside = hole.Corners.All(c => outer.SignedDistance(c) > 2.5 * ClearanceMetres);
            double sweep = random.Uniform(30, 90);
            var area = new PlannedArea(i, "random", outer, isInside ? [hole] : [], sweep);
            Check(area);
            Assert.InRange(area.Ratio, 0.9, MaxRandomRatio);
        }
    }

    [Theory]
    [InlineData("convex", 2)]
    [InlineData("concave", 17)]
    [InlineData("holes", 18)]
    [InlineData("sliver", 28)]
    public void Plan_InFlight_IsCoveredTooByAWayLittleLonger(string kind, int id)
    {
        PlannedArea planned = PlannedArea.All(isQuick: true).Single(a => a.Id == id);
        Assert.Equal(kind, planned.Kind);
        Check(planned);
        Assert.InRange(planned.Ratio, 0.9, 1.35);
    }

    [Fact]
    public void Plan_KeepOutThatLeavesANarrowPassage_KeepsClearOfIt()
    {
        // Between the keep-out and the border there is room for the clearance, and for nothing more.
        var area = new PlanePolygon([new(60, -60), new(60, 60), new(150, 60), new(150, -60)]);
        var shed = new PlanePolygon([new(125, -20), new(125, 15), new(140, 15), new(140, -20)]);
        foreach (bool isQuick in new[] { true, false })
        {
            SearchWay? way = SearchPlanner.Plan(area, [shed], ClearanceMetres, 30, null, default, isQuick);
            Assert.NotNull(way);
            for (int i = 0; i + 1 < way!.Corners.Count; i++)
            {
                Assert.InRange(
                    shed.DistanceTo(way.Corners[i], way.Corners[i + 1]), ClearanceMetres - 0.01,
                    double.PositiveInfinity);
            }
        }
    }

    private void Check(PlannedArea area)
    {
        var random = new SeededNumbers(area.Id);
        Assert.True(area.Way is not null, $"area {area.Id}");
        (int uncovered, double farthest) = area.Uncovered(random);
        double outside = SearchPlanner.OutsideFraction(area.Outer, area.Way!.Corners);
        output.WriteLine(FormattableString.Invariant(
            $"{area.Id} {area.Kind}: ratio {area.Ratio:0.000}, {area.Way.Corners.Count} corners, outside {outside:0.0%}, uncovered {uncovered} of {PlannedArea.Samples}, the farthest {farthest:0.000} of half a sweep"));
        Assert.Equal(0, uncovered);
        Assert.InRange(outside, 0, 0.001);
        Assert.InRange(area.HoleDistance(), ClearanceMetres - 0.1, double.PositiveInfinity);
        Assert.InRange(area.MinDepth(), -0.01, double.PositiveInfinity);
    }

    private static PlanePolygon Star(SeededNumbers random, PlanePoint centre, double size, int corners)
        => new(Enumerable.Range(0, corners).Select(i => centre
            + (random.Uniform(0.5, 1) * size
                * PlanePoint.Towards(2 * Math.PI * (i + random.Uniform(-0.3, 0.3)) / corners))));
}
