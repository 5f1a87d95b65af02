using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
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

    [Theory]
    [InlineData("convex", 5)]
    [InlineData("concave", 17)]
    [InlineData("holes", 24)]
    [InlineData("sliver", 28)]
    public void Plan_OneAreaOfEachKind_IsCoveredByAShortWay(string kind, int id)
    {
        PlannedArea planned = PlannedArea.All().Single(a => a.Id == id);
        Assert.Equal(kind, planned.Kind);
        Check(planned);
        Assert.InRange(planned.Ratio, 0.9, 1.3);
    }

    [Fact, Trait("Category", "Long")]
    public void Plan_AllAreas_AreCoveredByShortWays()
    {
        List<PlannedArea> all = PlannedArea.All().ToList();
        Assert.Equal(40, all.Count);
        all.ForEach(Check);
        foreach (IGrouping<string, PlannedArea> kind in all.GroupBy(a => a.Kind))
        {
            double mean = kind.Average(a => a.Ratio);
            double worst = kind.Max(a => a.Ratio);
            output.WriteLine(FormattableString.Invariant($"{kind.Key}: mean {mean:0.000}, worst {worst:0.000}"));
            Assert.InRange(mean, 0.9, kind.Key == "concave" ? 1.3 : 1.22);
        }
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
            Check(new PlannedArea(i, "random", outer, isInside ? [hole] : [], sweep));
        }
    }

    private void Check(PlannedArea area)
    {
        var random = new SeededNumbers(area.Id);
        Assert.True(area.Way is not null, $"area {area.Id}");
        (int uncovered, double farthest) = area.Uncovered(random);
        double outside = SearchPlanner.OutsideFraction(area.Outer, area.Way!.Corners);
        output.WriteLine(FormattableString.Invariant(
            $"{area.Id} {area.Kind}: ratio {area.Ratio:0.000}, {area.Way.Corners.Count} corners, outside {outside:0.0%}, uncovered {uncovered} of {PlannedArea.Samples}, the farthest {farthest:0.00} of half a sweep"));
        Assert.InRange(uncovered, 0, PlannedArea.Samples / 1000);
        Assert.InRange(farthest, 0, 1.05);
        Assert.InRange(area.HoleDistance(), ClearanceMetres - 0.1, double.PositiveInfinity);
        Assert.InRange(area.MinDepth(), -0.26 * area.Sweep, double.PositiveInfinity);
    }

    private static PlanePolygon Star(SeededNumbers random, PlanePoint centre, double size, int corners)
        => new(Enumerable.Range(0, corners).Select(i => centre
            + (random.Uniform(0.5, 1) * size
                * PlanePoint.Towards(2 * Math.PI * (i + random.Uniform(-0.3, 0.3)) / corners))));
}
