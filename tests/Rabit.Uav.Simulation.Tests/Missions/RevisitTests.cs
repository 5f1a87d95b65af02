using System;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Reporting;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>Targets that are observed once more, through a camera that does not look straight down.</summary>
public sealed class RevisitTests(ITestOutputHelper output)
{
    // Without reports of a revisit it stays at 9.5 m and more.
    private const double MaxHalfAxisMetres = 9;

    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot, -45, 0)]
    [InlineData(SimulatedAutopilot.Px4, -45, 0)]
    [InlineData(SimulatedAutopilot.ArduPilot, -60, 90)]
    public void Revisit_CameraPointsElsewhere_SeesEachTargetAgain(
        SimulatedAutopilot autopilot, double pitchDegrees, double yawDegrees)
    {
        string camera = FormattableString.Invariant(
            $"\"camera\": {{ \"gimbal\": true, \"pitchDegrees\": {pitchDegrees}, \"yawDegrees\": {yawDegrees} }},");

        // Low enough for the smallest target at this angle.
        string mission = SearchFlight.SmallMission.Replace("\"targets\"", camera + " \"targets\"")
            .Replace("\"heightMetres\": 30", "\"heightMetres\": 18")
            .Replace("\"laneSpacingMetres\": 22", "\"laneSpacingMetres\": 12");
        MissionPlan plan = MissionPlan.Parse(mission, "pitched");
        SimulationOptions world = SearchFlight.SmallWorld();
        (world.Autopilot, world.TargetCount) = (autopilot, 3);
        using var flight = new SearchFlight(plan, world);
        flight.Fly(TimeSpan.FromMinutes(20));
        output.WriteLine(flight.Log);

        Assert.InRange(flight.Mission.Revisits, 2, 3);
        Assert.Equal(0, flight.Mission.RevisitsFailed);
        foreach (TargetScore target in flight.Score().Targets)
            Assert.InRange(target.Track!.Covariance.HalfMajorAxis95Metres, 0, MaxHalfAxisMetres);
    }
}
