using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>A walker and a car that turns at every corner are followed in a search, by pictures alone.</summary>
public sealed class FollowTests(ITestOutputHelper output)
{
    private const double CapturedMetres = 8;
    private const double CapturedMetresPerSecond = 3;

    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(1);
    private static readonly string[] Classes = ["red", "orange", "blue", "yellow", "magenta"];

    [Fact]
    public void Search_WalkerAndCar_AreFollowedAndKeptInView()
    {
        // One of the ten below in which both are followed.
        FollowFigures figures = Fly(4);
        Assert.True(figures.Followed >= 2, $"followed {figures.Followed}");
        Assert.InRange(figures.InViewShare, 0.95, 1);
        Assert.InRange(figures.Rmse, 0, 4);
    }

    [Fact, Trait("Category", "Long")]
    public void Search_ManySeeds_TargetsAreKeptInView()
    {
        FollowFigures[] all = Enumerable.Range(1, 10).Select(Fly).ToArray();
        Assert.InRange(all.Sum(f => f.Followed), 10, int.MaxValue);
        Assert.InRange(all.Sum(f => f.InView) / (double)all.Sum(f => f.Samples), 0.95, 1);
        Assert.InRange(Math.Sqrt(all.Sum(f => f.SquaredErrors) / all.Sum(f => f.InView)), 0, 4);
    }

    private static SimulationOptions World(int seed) => new()
    {
        Seed = seed,
        TargetCount = Classes.Length,
        Motions = [SimulatedMotion.Walking, SimulatedMotion.Vehicle],
    };

    private FollowFigures Fly(int seed)
    {
        using var flight = new SearchFlight(
            SearchFlight.FollowingPlan(World(seed), "\"followSpeedMetresPerSecond\": 12"), World(seed));
        Dictionary<TargetClassName, SimulatedTarget> moving = flight.World.Targets
            .Where(t => t.Motion != SimulatedMotion.Standing).ToDictionary(t => t.Class);
        var figures = new FollowFigures();
        int captured = 0;
        flight.FlyUntil(
            f =>
            {
                if (Followed(f) is not { } track)
                    return f.IsOver;
                bool isInView = f.Reactor.Now - track.LastSeen <= MaxAge;
                captured = isInView && IsBelow(f, moving[track.Class]) ? track.Id : captured;
                if (captured == track.Id)
                    figures.Add(isInView, isInView ? ErrorOf(f, track, moving[track.Class]) : 0);
                return f.IsOver;
            },
            TimeSpan.FromMinutes(20));
        flight.End();
        figures.Followed = flight.Log.Split('\n').Count(l => l.Contains(": followed, "));
        output.WriteLine(string.Format(
            CultureInfo.InvariantCulture, "seed {0}: followed {1}, in view {2:0.000}, RMSE {3:0.00} m",
            seed, figures.Followed, figures.InViewShare, figures.Rmse));
        return figures;
    }

    // Also while it is searched for: then it is not in view.
    private static TargetTrack? Followed(SearchFlight flight)
        => flight.Tracks.Tracks.FirstOrDefault(
            t => flight.Mission.Text == FormattableString.Invariant($"following track {t.Id}")
                || flight.Mission.Text == FormattableString.Invariant($"searching for track {t.Id}"));

    // From there on it is captured: before, it may have left the picture while the vehicle turned to it.
    private static bool IsBelow(SearchFlight flight, SimulatedTarget target)
    {
        TruePose pose = flight.World.Truth.Pose;
        NedVector off = target.PositionAt(flight.Reactor.Now) - pose.Position;
        NedVector apart = target.VelocityAt(flight.Reactor.Now) - pose.VelocityNed;
        return Horizontal(off) <= CapturedMetres && Horizontal(apart) <= CapturedMetresPerSecond;
    }

    private static double Horizontal(NedVector v) => Math.Sqrt((v.North * v.North) + (v.East * v.East));

    private static double ErrorOf(SearchFlight flight, TargetTrack track, SimulatedTarget target)
    {
        GeodeticPosition truth = flight.World.PositionOf(target.PositionAt(track.Time));
        NedPosition off = LocalNedFrame.IgnoringGeoid(truth).ToNed(track.Position);
        return Horizontal(off - NedPosition.Origin);
    }

    private sealed class FollowFigures
    {
        public int Followed { get; set; }

        public int Samples { get; private set; }

        public int InView { get; private set; }

        public double SquaredErrors { get; private set; }

        public double InViewShare => InView / (double)Samples;

        public double Rmse => Math.Sqrt(SquaredErrors / InView);

        public void Add(bool isInView, double error)
        {
            Samples++;
            InView += isInView ? 1 : 0;
            SquaredErrors += error * error;
        }
    }
}
