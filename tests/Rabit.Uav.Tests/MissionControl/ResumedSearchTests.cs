using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Tests.Shared;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Tests.MissionControl;

/// <summary>Searches that end at a random moment, and are continued from their progress with a new battery.</summary>
public sealed class ResumedSearchTests(ITestOutputHelper output) : IDisposable
{
    private const string Area = "[[60,-100],[60,100],[180,100],[180,40],[120,20],[180,-30],[180,-100]]";
    private const string Revisit = ", \"revisit\": { \"maxWayFraction\": 1 }";
    private const int Targets = 6;

    // Positions of the two flights nearer than this to each other are on the same line.
    private const double SameLineMetres = 3;

    // What the vehicle needs to stop and to start again.
    private const double BrakingMetres = 10;

    // The file is written every 5 s; a program that dies loses what it did since.
    private const double WrittenSeconds = 5;

    private static readonly LocalNedFrame Frame = LocalNedFrame.IgnoringGeoid(MissionRig.Home);

    private readonly string _file = Path.Combine(
        Path.GetTempPath(), "rabit-resumed-" + Guid.NewGuid().ToString("N") + ".json");

    public void Dispose() => File.Delete(_file);

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void Resume_RandomMoment_FliesNothingTwiceAndFindsAll(int seed) => FlyTwice(seed);

    [Fact, Trait("Category", "Long")]
    public void Resume_20RandomMoments_FliesNothingTwiceAndFindsAll()
    {
        for (int seed = 1; seed <= 20; seed++)
            FlyTwice(seed);
    }

    private void FlyTwice(int seed)
    {
        var random = new SeededNumbers(1000 * seed); // neighbouring seeds give the same numbers, shifted
        var targets = new List<(double North, double East, TargetClassName Colour)>();
        while (targets.Count < Targets)
        {
            var at = new PlanePoint(random.Uniform(60, 180), random.Uniform(-100, 100));
            bool isApart = targets.All(t => at.DistanceTo(new PlanePoint(t.North, t.East)) > 15);
            if (isApart && PolygonOfArea().SignedDistance(at) > 0)
                targets.Add((at.North, at.East, DefaultTargetClasses.Red));
        }

        (HashSet<int> all, double whole, _, _) = Fly(targets, resume: null, endAfter: null, returns: true);
        double end = random.Uniform(20, whole - 30);
        bool returns = seed % 2 == 0;
        (HashSet<int> first, _, List<PlanePoint> flown, double speed) = Fly(targets, null, end, returns);
        MissionProgress progress = MissionProgress.ReadFile(_file);
        (HashSet<int> second, _, List<PlanePoint> again, _) = Fly(targets, progress, null, true);

        double twice = LengthNear(again, flown);
        double overlap = 3 * speed;
        output.WriteLine(FormattableString.Invariant(
            $"seed {seed}: ended {(returns ? "by a return" : "at once")} after {end:0} of {whole:0} s, {twice:0.0} m flown twice, targets {string.Join(" ", first)} and then {string.Join(" ", second)}"));
        Assert.Equal(Targets, all.Count);
        first.UnionWith(second);
        Assert.True(all.SetEquals(first), "not the same targets");
        Assert.InRange(twice, 0, overlap + BrakingMetres + (returns ? 0 : WrittenSeconds * speed));
    }

    // The targets that the mission knows at the end, its time in the search, and where it flew along lanes.
    private (HashSet<int> Found, double Seconds, List<PlanePoint> Way, double Speed) Fly(
        List<(double North, double East, TargetClassName Colour)> targets, MissionProgress? resume, double? endAfter,
        bool returns)
    {
        using var rig = new MissionRig(MissionRig.Mission(Revisit, Area), o =>
        {
            o.ProgressFile = resume is null && endAfter is not null ? _file : null;
            o.Resume = resume;
        });
        rig.Vehicle.Targets.AddRange(targets);
        rig.RunUntil(MissionPhase.Searching);
        var way = new List<PlanePoint>();
        TimeSpan begun = rig.Now;
        bool isAborted = false;
        while (rig.Status.Phase is MissionPhase.Searching or MissionPhase.Revisiting && !isAborted)
        {
            rig.Run(0.1);
            if (rig.Status.Phase == MissionPhase.Searching && rig.Manager.Flight!.Route!.FlownMetresOfLeg > 0)
                way.Add(new PlanePoint(rig.Vehicle.North, rig.Vehicle.East));
            isAborted = endAfter is { } seconds && (rig.Now - begun).TotalSeconds >= seconds;
        }

        double took = (rig.Now - begun).TotalSeconds;
        if (isAborted && returns)
        {
            rig.Manager.ReturnToLaunch("test", "the battery");
            rig.Run(2);
        }

        if (!isAborted)
        {
            Assert.Equal(MissionPhase.Done, rig.RunToEnd());
            Assert.InRange(rig.Status.Coverage, 0.985, 1);
        }

        return ([.. rig.Vehicle.Tracks.Where(t => t.State == TrackState.Confirmed).Select(t => t.Id)], took, way,
            rig.Manager.Flight!.Mission.SpeedMetresPerSecond);
    }

    private static PlanePolygon PolygonOfArea()
    {
        MissionPlan mission = MissionRig.Mission(Revisit, Area);
        return new PlanePolygon(
            mission.Area.Select(c => Frame.ToNed(c)).Select(n => new PlanePoint(n.North, n.East)));
    }

    // How much of a way runs along another, in its direction or against it: crossing it does not count.
    private static double LengthNear(List<PlanePoint> way, List<PlanePoint> other)
    {
        double sum = 0;
        for (int i = 1; i < way.Count; i++)
        {
            PlanePoint step = way[i] - way[i - 1];
            if (step.Length < 0.05 || step.Length > 5)
                continue;
            for (int k = 1; k < other.Count; k++)
            {
                PlanePoint along = other[k] - other[k - 1];
                bool isSame = along.Length is > 0.05 and < 5 && way[i].DistanceTo(other[k]) < SameLineMetres
                    && Math.Abs(step.Cross(along)) < 0.3 * step.Length * along.Length;
                if (!isSame)
                    continue;
                sum += step.Length;
                break;
            }
        }

        return sum;
    }
}
