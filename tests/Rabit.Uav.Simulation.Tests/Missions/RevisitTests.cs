using System;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Reporting;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>Targets that are observed once more, through a camera that does not look straight down.</summary>
public sealed class RevisitTests(ITestOutputHelper output)
{
    // Two passes at one or two pictures a second, in which the target is in view for some seconds.
    private const int MinReports = 10;

    // What the mount's error does to a view at 45 degrees from this height does not average out where the lane had the
    // same heading.
    private const double MaxHalfAxisMetres = 10;

    private static readonly Regex Reports = new(
        @"track \d+: (?<count>\d+) more reports", RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture);

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
        int[] reports = Reports.Matches(flight.Log).Cast<Match>()
            .Select(m => int.Parse(m.Groups["count"].Value, CultureInfo.InvariantCulture)).ToArray();
        Assert.Equal(flight.Mission.Revisits, reports.Length);
        Assert.All(reports, r => Assert.True(r >= MinReports, $"only {r} reports of a revisit"));
        foreach (TargetScore target in flight.Score().Targets)
            Assert.InRange(target.Track!.Covariance.HalfMajorAxis95Metres, 0, MaxHalfAxisMetres);
    }
}
