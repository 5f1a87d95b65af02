using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Reporting;
using Rabit.Uav.Simulation.Tests.Camera;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>Searches in wind with the camera on a stabilised gimbal, whose report says where it looks.</summary>
public sealed class GimbalFlightTests(ITestOutputHelper output)
{
    // Of SearchTests, whose camera is fixed.
    private const double MaxRmse = 3;

    [Theory]
    [InlineData(SimulatedGimbal.FollowsHeading, SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedGimbal.HoldsNorth, SimulatedAutopilot.Px4)]
    public void Search_InWind_TargetsAreWhereTheReportOfTheGimbalPutsThem(
        SimulatedGimbal gimbal, SimulatedAutopilot autopilot)
    {
        (List<TargetScore> scores, int falseTracks) = Fly(seed: 6, gimbal, autopilot, filter: null);

        Assert.Equal(3, scores.Count(s => s.Track is not null));
        Assert.Equal(0, falseTracks);
        Assert.True(Rmse(scores) <= MaxRmse, $"seed 6: RMSE {Rmse(scores)} m");
    }

    [Fact]
    public void Search_FlagsOfTheReportIgnored_TargetsAreElsewhere()
    {
        GimbalFlagFilter? filter = null;
        (List<TargetScore> scores, _) = Fly(
            seed: 6, SimulatedGimbal.FollowsHeading, SimulatedAutopilot.ArduPilot, link => filter = new(link));

        Assert.True(filter!.Reports > 100, $"seed 6: {filter.Reports} reports of the gimbal");
        Assert.True(
            scores.Any(s => s.Track is null) || Rmse(scores) > MaxRmse, $"seed 6: RMSE {Rmse(scores)} m all the same");
    }

    private (List<TargetScore> Scores, int FalseTracks) Fly(
        long seed, SimulatedGimbal gimbal, SimulatedAutopilot autopilot, Func<Links.IByteLink, Links.IByteLink>? filter)
    {
        var options = new SimulationOptions
        {
            Seed = seed,
            Autopilot = autopilot,
            TargetCount = 3,
            DistractorCount = 2,
            WindMetresPerSecond = 6.5,
            Camera = SimulatedCameraOptions.CreateLowResolution(),
        };
        options.Camera.Gimbal = gimbal;
        MissionPlan plan = MissionPlan.Parse(
            SearchFlight.SmallMission.Replace("\"targets\":", "\"camera\": { \"gimbal\": true }, \"targets\":"),
            "gimbal");
        using var flight = new SearchFlight(plan, options, new VirtualTime(seed), [], around: filter);
        flight.Fly(TimeSpan.FromMinutes(10));
        MissionScore score = flight.Score();
        output.WriteLine(FormattableString.Invariant(
            $"{gimbal}, {autopilot}, seed {seed}: {flight.Mission.Phase}, RMSE {Rmse(score.Targets):0.00} m, {score.FalseTracks.Count} false tracks, greatest tilt {MaxTilt(flight):0.0} degrees"));
        foreach (TargetScore target in score.Targets)
            output.WriteLine("  " + target);
        Assert.True(flight.Mission.Phase == MissionPhase.Done, flight.Mission.Text + "\n" + flight.Log);
        return (score.Targets.ToList(), score.FalseTracks.Count);
    }

    private static double MaxTilt(SearchFlight flight)
        => flight.World.Truth.Path.Max(
            p => Math.Max(Math.Abs(p.Attitude.Pitch.Degrees), Math.Abs(p.Attitude.Roll.Degrees)));

    private static double Rmse(IReadOnlyCollection<TargetScore> scores)
        => Math.Sqrt(scores.Where(s => s.Track is not null).Select(s => s.ErrorMetres * s.ErrorMetres)
            .DefaultIfEmpty(0).Average());
}
