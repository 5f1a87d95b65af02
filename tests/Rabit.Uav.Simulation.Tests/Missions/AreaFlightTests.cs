using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.Json;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.CameraGeometry;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>Areas of many shapes, flown by all managers in wind, with a camera that sees what is searched.</summary>
public sealed class AreaFlightTests(ITestOutputHelper output) : IDisposable
{
    private const double SpeedMetresPerSecond = 10;
    private const int MaxBatteries = 5;
    private const double KeepOutMetres = 5;
    private const double MarginMetres = 80;

    // A picture is 1.2 heights wide; the vehicle drifts and tilts in gusts.
    private const double SpacingInHeights = 1.05;
    private const double MaxHeightMetres = 118;

    private static readonly GeodeticPosition Origin = GeodeticPosition.FromDegrees(47.3971, 8.5445, 488);

    private readonly string _file = Path.Combine(
        Path.GetTempPath(), "rabit-area-" + Guid.NewGuid().ToString("N") + ".json");

    public void Dispose() => File.Delete(_file);

    // Of some the battery flies half in one flight; the rest is resumed with new ones.
    [Theory, Trait("Category", "Long")]
    [InlineData(1, 6)]
    [InlineData(2, 5)]
    [InlineData(3, 2)]
    [InlineData(5, 4)]
    [InlineData(6, 3)]
    [InlineData(11, 7)]
    [InlineData(16, 4)]
    [InlineData(18, 6)]
    [InlineData(24, 8)]
    [InlineData(28, 8)]
    public void Search_AreaInWind_IsSeenInsideTheFence(int id, double wind)
    {
        using var data = JsonDocument.Parse(
            File.ReadAllText(Path.Combine(Repository.Root, "tests", "data", "autonomy", "search-areas.json")));
        JsonElement area = data.RootElement.EnumerateArray().Single(a => a.GetProperty("id").GetInt32() == id);
        var plan = MissionPlan.Parse(Text(area, area.GetProperty("sweep_width_m").GetDouble()), "area");
        MissionProgress? progress = null;
        for (int battery = 1; battery <= MaxBatteries; battery++)
        {
            MissionStatus status = Fly(plan, id, wind, progress);
            Assert.Equal(MissionPhase.Done, status.Phase);
            if (status.Aborted is null)
            {
                Assert.InRange(status.Coverage, 0.98, 1);
                return;
            }

            Assert.Contains("battery", status.Aborted, StringComparison.Ordinal);
            progress = MissionProgress.ReadFile(_file);
        }

        Assert.Fail($"not searched with {MaxBatteries} batteries");
    }

    private MissionStatus Fly(MissionPlan mission, int id, double wind, MissionProgress? progress)
    {
        var world = new SimulationOptions
        {
            Seed = id,
            WindMetresPerSecond = wind,
            TargetCount = 1,
            DistractorCount = 0,
            Camera = new SimulatedCameraOptions
            {
                FramesPerSecond = 1,

                // 0.13 m per pixel from the greatest height: coarser pictures make Health Monitoring hold.
                Camera = new CameraModel
                {
                    Width = 960,
                    Height = 480,
                    FocalX = 800,
                    FocalY = 800,
                    CentreX = 479.5,
                    CentreY = 239.5,
                },
            },
        };
        using var flight = new SearchFlight(mission, world, new VirtualTime(id), [], change: o =>
        {
            o.AllowsPartialSearch = true;
            o.ProgressFile = _file;
            o.Resume = progress;
        });
        var path = new List<NedPosition>();
        var ownPath = new List<NedPosition>();
        double searched = 0;
        flight.FlyUntil(
            f =>
            {
                NedPosition at = f.World.Truth.Pose.Position;
                if (path.Count > 0 && f.Mission.Phase == MissionPhase.Searching)
                    searched += at.HorizontalDistanceTo(path[path.Count - 1]);
                path.Add(at);

                // The autopilot's return is straight, also over a keep-out.
                if (f.Mission.Phase is not (MissionPhase.Returning or MissionPhase.Landing or MissionPhase.Done))
                    ownPath.Add(at);
                return f.IsOver;
            },
            TimeSpan.FromMinutes(60));
        flight.End();

        SearchPlan plan = flight.Mission.Plan!;
        List<NedPosition> lanes = Places(plan.Lanes, plan);
        double planned = Enumerable.Range(1, lanes.Count - 1).Sum(i => lanes[i].HorizontalDistanceTo(lanes[i - 1]));
        List<NedPosition> fence = Places(plan.Fence, plan);
        double inFence = path.Min(p => SignedDistance(fence, p));
        double fromKeepOuts = plan.KeepOuts.IsDefaultOrEmpty ? double.PositiveInfinity
            : plan.KeepOuts.Min(k => ownPath.Min(p => -SignedDistance(Places(k, plan), p)));
        output.WriteLine(FormattableString.Invariant(
            $"area {id}, wind {wind} m/s: {flight.Mission.Phase}, {flight.Mission.Text}, {flight.Mission.Aborted}; {flight.Mission.Coverage:P1} seen in {flight.Reactor.Now.TotalSeconds:0} s, planned {planned:0} m, flown {searched:0} m in the search, {inFence:0.0} m inside the fence, {fromKeepOuts:0.0} m from keep-outs, battery {flight.World.Truth.BatteryRemaining:P0}"));
        output.WriteLine(string.Join("\n", flight.Log.Split('\n').Where(l => !l.Contains(": command ")).Take(60)));
        Assert.InRange(inFence, 0, double.PositiveInfinity);
        Assert.InRange(fromKeepOuts, KeepOutMetres, double.PositiveInfinity);
        return flight.Mission;
    }

    // Home is the first corner of the area.
    private static string Text(JsonElement area, double sweep)
    {
        JsonElement[] outer = [.. area.GetProperty("outer_ne").EnumerateArray()];
        (double north, double east) = (outer[0][0].GetDouble(), outer[0][1].GetDouble());
        var frame = LocalNedFrame.IgnoringGeoid(Origin);
        string Ring(IEnumerable<JsonElement> corners) => "[" + string.Join(",", corners.Select(c =>
        {
            GeodeticPosition p = frame.ToGeodetic(
                new NedPosition(c[0].GetDouble() - north, c[1].GetDouble() - east, 0));
            return string.Format(
                CultureInfo.InvariantCulture, "[{0:R},{1:R}]", p.Latitude.Degrees, p.Longitude.Degrees);
        })) + "]";
        string holes = string.Join(
            ",", area.GetProperty("holes_ne").EnumerateArray().Select(h => Ring(h.EnumerateArray())));
        double height = Math.Min(MaxHeightMetres, sweep / SpacingInHeights);
        return FormattableString.Invariant(
            $"{{ \"area\": {Ring(outer)}, \"keepOuts\": [{holes}], \"heightMetres\": {height:0.0}, \"speedMetresPerSecond\": {SpeedMetresPerSecond}, \"laneSpacingMetres\": {sweep}, \"fenceMarginMetres\": {MarginMetres}, \"revisit\": {{ \"enabled\": false }} }}");
    }

    private static List<NedPosition> Places(IEnumerable<GeodeticPosition> places, SearchPlan plan)
    {
        var frame = LocalNedFrame.IgnoringGeoid(plan.Home);
        return [.. places.Select(p => frame.ToNed(p))];
    }

    // To the border of a polygon, positive inside (even-odd rule).
    private static double SignedDistance(List<NedPosition> corners, NedPosition p)
    {
        bool isInside = false;
        double least = double.PositiveInfinity;
        for (int i = 0; i < corners.Count; i++)
        {
            (NedPosition a, NedPosition b) = (corners[i], corners[(i + 1) % corners.Count]);
            (double north, double east) = (b.North - a.North, b.East - a.East);
            double part = (((p.North - a.North) * north) + ((p.East - a.East) * east))
                / ((north * north) + (east * east));
            part = Math.Max(0, Math.Min(1, part));
            least = Math.Min(
                least, p.HorizontalDistanceTo(new NedPosition(a.North + (part * north), a.East + (part * east), 0)));
            if ((a.North > p.North) != (b.North > p.North) && p.East < a.East + (east * (p.North - a.North) / north))
                isInside = !isInside;
        }

        return isInside ? least : -least;
    }
}
