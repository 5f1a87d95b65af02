using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Simulation.Tests.Missions;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Group;

/// <summary>Two whole companion computers follow a car by pictures, one after the other.</summary>
public sealed class GroupFollowTests(ITestOutputHelper output)
{
    private static readonly int[] Vehicles = [0, 1];
    private static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(1.5);

    [Theory, Trait("Category", "Long")]
    [InlineData(3, SimulatedAutopilot.ArduPilot)]
    [InlineData(4, SimulatedAutopilot.ArduPilot)]
    [InlineData(5, SimulatedAutopilot.ArduPilot)]
    [InlineData(6, SimulatedAutopilot.ArduPilot)]
    [InlineData(3, SimulatedAutopilot.Px4)]
    [InlineData(4, SimulatedAutopilot.Px4)]
    public void Follower_BatteryIsLow_IsRelievedByTheOtherWithTheTargetInView(long seed, SimulatedAutopilot autopilot)
    {
        (int first, TimeSpan at) = FirstFollower(seed, autopilot);
        using GroupFlight flight = Open(seed, autopilot, (first, new ScriptedFault
        {
            Kind = ScriptedFaultKind.BatteryTo,
            At = at + TimeSpan.FromSeconds(20),
            Value = 0.36,
        }));

        Assert.True(flight.RunUntil(() => Followed(flight).Progress == FollowProgress.InView, 200), flight.Log);
        var time = new InViewTime(flight);
        Assert.True(flight.RunUntil(() => time.Add() && Followed(flight).Follower == 2 - first, 200), flight.Log);
        Assert.True(
            flight.RunUntil(() => time.Add() && Followed(flight).Progress == FollowProgress.InView, 60), flight.Log);
        Assert.True(flight.RunUntil(() => time.Add() && Followed(flight).State == FollowState.Closed, 300), flight.Log);
        output.WriteLine(FormattableString.Invariant($"seed {seed}: in view {time.Share:F3} of {time.All}"));

        Assert.InRange(time.Share, 0.95, 1);
        Assert.Equal(FollowResult.Followed, Followed(flight).Result);
        Assert.True(flight.RunToEnd(), flight.Log);
        Assert.Empty(flight.Group.TooNear);
        Assert.All(Vehicles, i => Assert.True(
            flight.Mission(i).Result.Outcome == MissionOutcome.Accomplished, flight.Log));
    }

    private static (int Vehicle, TimeSpan At) FirstFollower(long seed, SimulatedAutopilot autopilot)
    {
        using GroupFlight flight = Open(seed, autopilot);
        Assert.True(flight.RunUntil(() => Vehicles.Any(i => IsFollowing(flight, i)), 400), flight.Log);
        return (Vehicles.First(i => IsFollowing(flight, i)), flight.Group.Now);
    }

    // As one that flies knows of it.
    private static FollowTask Followed(GroupFlight flight)
        => Vehicles.Where(i => flight.Group.Vehicles[i].HasStarted)
            .SelectMany(i => flight.GroupStatus(i).Followings).FirstOrDefault();

    private static bool IsFollowing(GroupFlight flight, int vehicle)
        => flight.Mission(vehicle).Text?.StartsWith("following track ", StringComparison.Ordinal) == true;

    private static GroupFlight Open(
        long seed, SimulatedAutopilot autopilot, params (int Vehicle, ScriptedFault Fault)[] faults)
    {
        var world = new SimulationOptions
        {
            Seed = seed,
            Autopilot = autopilot,
            TargetCount = 1,
            DistractorCount = 3,
            Motions = [SimulatedMotion.Vehicle],
            Camera = new SimulatedCameraOptions { Gimbal = SimulatedGimbal.FollowsHeading },
        };
        MissionPlan plan = SearchFlight.FollowingPlan(
            world, "\"followSeconds\": 300, \"followSpeedMetresPerSecond\": 12, \"maxWayFraction\": 3").WithGimbal();
        return new GroupFlight(
            plan,
            new SimulatedGroupOptions
            {
                Vehicles = 2,
                World = world,
                VehicleFaults = faults.ToDictionary(
                    f => f.Vehicle, f => (IReadOnlyList<ScriptedFault>)[f.Fault]),
            },
            layerSpacingMetres: 19);
    }

    // Of one target, by the tracks of both vehicles.
    private sealed class InViewTime(GroupFlight flight)
    {
        private TimeSpan _seen;
        private TimeSpan? _last;

        public TimeSpan All { get; private set; }

        public double Share => _seen.TotalSeconds / All.TotalSeconds;

        // Always true.
        public bool Add()
        {
            TimeSpan step = flight.Group.Now - (_last ?? flight.Group.Now);
            _last = flight.Group.Now;
            All += step;
            TargetClassName name = flight.Group.Vehicles[0].World.Targets.First().Class;
            if (Vehicles.Any(i => flight.Tracks(i).Tracks.Any(
                t => t.Class == name && flight.Group.Now - t.LastSeen <= MaxAge)))
                _seen += step;
            return true;
        }
    }
}
