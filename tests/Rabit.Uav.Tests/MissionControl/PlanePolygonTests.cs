using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Against shapely (tests/data/autonomy/search.json).</summary>
public class PlanePolygonTests
{
    [Fact]
    public void Polygons_AreaAndPoints_AreThoseOfTheReference()
    {
        using JsonDocument data = TestData.Autonomy("search.json");
        int points = 0;
        foreach (JsonElement element in data.RootElement.EnumerateArray())
        {
            PlanePolygon polygon = Read(element);
            double area = element.GetProperty("area_plane_m2").GetDouble();
            Assert.InRange(polygon.Area, area * (1 - 1e-8), area * (1 + 1e-8));
            Assert.Null(polygon.FindCrossing());
            foreach (JsonElement point
                in element.GetProperty("points").EnumerateArray().Where(p => p[2].GetString() != "boundary"))
            {
                var p = new PlanePoint(point[0].GetDouble(), point[1].GetDouble());
                Assert.Equal(point[2].GetString() == "inside", polygon.Contains(p));
                Assert.Equal(point[3].GetDouble(), polygon.SignedDistance(p), 1e-4);
                points++;
            }
        }

        Assert.InRange(points, 100, 1000);
    }

    [Fact]
    public void Lanes_ConvexPolygons_AreAsFewAsTheHullAllows()
    {
        using JsonDocument data = TestData.Autonomy("search.json");
        foreach (JsonElement element
            in data.RootElement.EnumerateArray().Where(e => e.GetProperty("kind").GetString() == "convex"))
        {
            PlanePolygon polygon = Read(element);
            double sweep = element.GetProperty("sweep_width_m").GetDouble();
            IReadOnlyList<LaneSegment> lanes = LanePlanner.Plan(polygon, sweep, null, default);
            Assert.Equal(element.GetProperty("lanes_along_hull_min_width").GetInt32(), lanes.Count);

            // No way can be shorter; ours ends a little outside.
            double bound = element.GetProperty("path_lower_bound_m").GetDouble();
            Assert.InRange(lanes.Sum(l => l.Length), bound * 0.9, bound * 1.5);
        }
    }

    [Fact]
    public void FindCrossing_BowTieAndTouchingCorner_AreFound()
    {
        Assert.NotNull(Polygon((0, 0), (10, 10), (10, 0), (0, 10)).FindCrossing());
        Assert.NotNull(Polygon((0, 0), (10, 0), (10, 10), (5, 0), (0, 10)).FindCrossing());
        Assert.NotNull(Polygon((0, 0), (10, 0), (5, 0)).FindCrossing());
        Assert.Null(Polygon((0, 0), (10, 0), (10, 10), (5, 1), (0, 10)).FindCrossing());
    }

    [Fact]
    public void Grown_HullOfPoints_HoldsThemByTheMarginAndHardlyMore()
    {
        PlanePolygon hull = PlanePolygon.HullOf([new(0, 0), new(100, 0), new(100, 60), new(0, 60), new(50, 30)]);
        Assert.Equal(4, hull.Corners.Count);
        PlanePolygon fence = hull.Grown(40);
        Assert.All(hull.Corners, c => Assert.InRange(fence.SignedDistance(c), 40 - 1e-9, 41));
        Assert.Equal(0, fence.SignedDistance(new PlanePoint(50, 100.8)), 1.0);
    }

    private static PlanePolygon Read(JsonElement element)
        => new(
            element.GetProperty("outer_ne").EnumerateArray()
                .Select(c => new PlanePoint(c[0].GetDouble(), c[1].GetDouble())));

    private static PlanePolygon Polygon(params (double North, double East)[] corners)
        => new(corners.Select(c => new PlanePoint(c.North, c.East)));
}
