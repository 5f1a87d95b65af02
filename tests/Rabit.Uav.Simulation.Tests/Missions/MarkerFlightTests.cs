using System;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Reporting;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>Searches for printed markers, which the mission file declares, beside coloured panels.</summary>
public sealed class MarkerFlightTests(ITestOutputHelper output)
{
    private const double MaxRmse = 3;

    // Some 25 pixels across at 30 m.
    private const string Classes =
        """
        "targetClasses": {
            "aruco": { "marker": { "family": "ArUco4x4" }, "minSideMetres": 1.2, "maxSideMetres": 2 },
            "apriltag": { "marker": { "family": "AprilTag36h11" }, "minSideMetres": 1.2, "maxSideMetres": 2 }
          },
          "targets": ["aruco", "apriltag", 
        """;

    [Fact]
    public void Search_MarkersAmongThePanels_AreFoundByTheirClasses()
    {
        MissionPlan plan = MissionPlan.Parse(
            SearchFlight.SmallMission.Replace("\"targets\": [", Classes.TrimEnd() + " "), "markers");
        var options = new SimulationOptions
        {
            Seed = 9,
            TargetCount = 4,
            DistractorCount = 3,
            TargetKinds =
            [
                SimulatedTargetKind.AprilTagMarker, SimulatedTargetKind.ColouredPanel,
                SimulatedTargetKind.ArUcoMarker,
            ],
        };
        using var flight = new SearchFlight(plan, options);
        flight.Fly(TimeSpan.FromMinutes(10));
        MissionScore score = flight.Score();
        output.WriteLine($"seed 9: {flight.Mission.Phase}, {flight.Mission.Text}");
        foreach (TargetScore target in score.Targets)
            output.WriteLine("  " + target);

        Assert.True(flight.Mission.Phase == MissionPhase.Done, flight.Mission.Text + "\n" + flight.Log);
        Assert.Equal(
            ["apriltag", "apriltag", "aruco"],
            score.Targets.Select(t => t.Class.ToString()).Where(c => c[0] == 'a')
                .OrderBy(c => c));
        Assert.All(score.Targets, t => Assert.True(t.Track is not null, $"seed 9: {t}"));
        Assert.Empty(score.FalseTracks);
        double rmse = Math.Sqrt(score.Targets.Average(t => t.ErrorMetres * t.ErrorMetres));
        Assert.True(rmse <= MaxRmse, $"seed 9: RMSE {rmse} m");
    }
}
