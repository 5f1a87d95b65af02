using System;
using System.Globalization;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.MissionControl;

public class KeepOutTests(ITestOutputHelper output)
{
    private static readonly PlanePoint[] _pond = [new(90, -20), new(90, 15), new(125, 15), new(125, -20)];

    [Fact]
    public void Mission_KeepOutInTheArea_IsFlownAroundAndNotCounted()
    {
        using var rig = new MissionRig(MissionRig.Mission(", \"keepOuts\": [" + Corners(_pond) + "]"));
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        var pond = new PlanePolygon(_pond);
        double nearest = rig.Vehicle.Path.Where(p => p.Height > 20)
            .Min(p => -pond.SignedDistance(new PlanePoint(p.North, p.East)));
        output.WriteLine($"{nearest:0.0} m from it, {rig.Status.Coverage:0.000} covered");
        Assert.InRange(nearest, 5, 100);
        Assert.InRange(rig.Status.Coverage, 0.985, 1);
        Assert.Equal(MissionOutcome.Accomplished, rig.Status.Result.Outcome);
    }

    [Theory]
    [InlineData("[[-20,-20],[-20,20],[20,20],[20,-20]]", "keepOuts[0] contains home")]
    [InlineData("[[90,-90],[90,90],[110,90],[110,-90]]", "the keepOuts cut the area in two, or leave nothing of it")]
    public void Mission_KeepOutThatCannotBe_IsRefusedByName(string corners, string fault)
    {
        using System.Text.Json.JsonDocument ring = System.Text.Json.JsonDocument.Parse(corners);
        PlanePoint[] points = ring.RootElement.EnumerateArray()
            .Select(c => new PlanePoint(c[0].GetDouble(), c[1].GetDouble())).ToArray();
        MissionPlan mission = MissionRig.Mission(", \"keepOuts\": [" + Corners(points) + "]");
        Assert.Null(FlightPlan.Create(mission, MissionRig.Home, out string why));
        Assert.StartsWith(fault, why, StringComparison.Ordinal);
    }

    [Fact]
    public void Parse_GeoJsonPolygonWithAHole_IsAreaAndKeepOut()
    {
        const string Text = """
            {"area": {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [
                [[8.5445, 47.3982], [8.5467, 47.3982], [8.5467, 47.3993], [8.5445, 47.3993], [8.5445, 47.3982]],
                [[8.5455, 47.3986, 5], [8.5456, 47.3986, 5], [8.5456, 47.3988, 5], [8.5455, 47.3986, 5]]]}},
             "heightMetres": 40, "speedMetresPerSecond": 6, "laneSpacingMetres": 30}
            """;
        MissionPlan mission = MissionPlan.Parse(Text, "test");
        Assert.Equal(4, mission.Area.Length);
        Assert.Equal((47.3982, 8.5445), (mission.Area[0].Latitude.Degrees, mission.Area[0].Longitude.Degrees));
        Assert.Equal(3, Assert.Single(mission.KeepOuts).Length);
    }

    [Theory]
    [InlineData("\"keepOuts\": 5", "keepOuts is 5; it must be a list")]
    [InlineData("\"keepOuts\": [5]", "keepOuts[0] is 5; it must be a list of corners or a GeoJSON Polygon")]
    [InlineData("\"keepOuts\": [[[47.1,8.5],[47.1]]]", "keepOuts[0][1] is [47.1]; it must be [latitude, longitude]")]
    [InlineData("\"keepOuts\": [[[47.3984,8.5456],[47.3985,8.5456]]]", "keepOuts[0] has 2 corners")]
    [InlineData(
        "\"keepOuts\": [[[47.3984,8.5456],[47.3986,8.5458],[47.3986,8.5456],[47.3984,8.5458]]]",
        "keepOuts[0] crosses itself")]
    [InlineData(
        "\"keepOuts\": [[[47.3984,8.5456],[47.3986,8.5458],[67.3986,8.5456]]]", "m from area[0]; corners must be")]
    [InlineData(
        "\"keepOuts\": [{\"type\": \"MultiPolygon\", \"coordinates\": []}]", "with coordinates, not a MultiPolygon")]
    [InlineData(
        "\"keepOuts\": [{\"type\": \"Polygon\", \"coordinates\": [[[8.5,97],[8.5,47]]]}]",
        "keepOuts[0].coordinates[0][0] is [8.5,97]; it must be [longitude, latitude] in degrees")]
    public void Parse_WrongKeepOut_IsReportedWithPathAndValue(string property, string text)
    {
        MissionPlanException e = Assert.Throws<MissionPlanException>(
            () => MissionPlan.Parse(MissionRig.Text(", " + property), "test"));
        Assert.Contains(text, e.Message, StringComparison.Ordinal);
        Assert.Single(e.Faults);
    }

    [Fact]
    public void Parse_TooManyCorners_IsRefused()
    {
        string many = string.Join(",", Enumerable.Repeat("[47.3984,8.5456]", 60));
        MissionPlanException e = Assert.Throws<MissionPlanException>(
            () => MissionPlan.Parse(MissionRig.Text(", \"keepOuts\": [[" + many + "]]"), "test"));
        Assert.Contains("1 keepOuts with 60 corners; the limits are 10 and 50", e.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Replan_InMidSearch_FliesWhatIsLeftAroundTheKeepOut()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Run(30);
        MissionFlight flight = rig.Manager.Flight!;
        double seen = flight.Route!.Coverage.Fraction;
        Assert.InRange(seen, 0.2, 0.7);
        PlanePoint[] shed = [new(125, -20), new(125, 15), new(140, 15), new(140, -20)];
        Assert.Null(flight.Replan(MissionRig.Mission(", \"keepOuts\": [" + Corners(shed) + "]")));
        Assert.InRange(flight.Route.Coverage.Fraction, seen, seen + 0.1);
        int before = rig.Vehicle.Path.Count;
        Assert.Equal(MissionPhase.Done, rig.RunToEnd());
        var polygon = new PlanePolygon(shed);
        Assert.All(
            flight.Plan!.Lanes, l => Assert.InRange(polygon.DistanceTo(l.Start, l.End), 9.9, 200));
        double nearest = rig.Vehicle.Path.Skip(before)
            .Min(p => -polygon.SignedDistance(new PlanePoint(p.North, p.East)));
        output.WriteLine($"{nearest:0.0} m from it");
        Assert.InRange(nearest, 7, 200);
        Assert.InRange(rig.Status.Coverage, 0.985, 1);
    }

    [Fact]
    public void Replan_VehicleInAKeepOut_IsRefused()
    {
        using var rig = new MissionRig(MissionRig.Mission());
        rig.RunUntil(MissionPhase.Searching);
        rig.Run(8);
        MissionFlight flight = rig.Manager.Flight!;
        PlanePoint at = flight.Position;
        PlanePoint[] here = [at + new PlanePoint(-5, -5), at + new PlanePoint(-5, 5), at + new PlanePoint(5, 0)];
        FlightPlan? before = flight.Plan;
        Assert.Equal(
            "the vehicle is inside a keep-out",
            flight.Replan(MissionRig.Mission(", \"keepOuts\": [" + Corners(here) + "]")));
        Assert.Same(before, flight.Plan);
    }

    private static string Corners(PlanePoint[] points)
    {
        LocalNedFrame frame = LocalNedFrame.IgnoringGeoid(MissionRig.Home);
        return "[" + string.Join(",", points.Select(p =>
        {
            GeodeticPosition at = frame.ToGeodetic(new NedPosition(p.North, p.East, 0));
            return string.Format(
                CultureInfo.InvariantCulture, "[{0:R},{1:R}]", at.Latitude.Degrees, at.Longitude.Degrees);
        })) + "]";
    }
}
