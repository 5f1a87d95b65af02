using System;
using System.Linq;
using System.Threading.Tasks;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Rabit.Uav.Reporting;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>
/// Searches for targets of mixed kinds: panels of one and of two colours, black and white, persons, cars and markers.
/// </summary>
public sealed class MixedTargetFlightTests(ITestOutputHelper output)
{
    private const double MaxRmse = 3;

    private static readonly SimulatedTargetKind[] AllKinds =
        [.. Enumerable.Range(0, 8).Select(k => (SimulatedTargetKind)k)];

    private static string At45Degrees => SearchFlight.BundledText
        .Replace("\"heightMetres\": 40", "\"heightMetres\": 20")
        .Replace(
            "\"laneSpacingMetres\": 30",
            "\"laneSpacingMetres\": 14, \"camera\": { \"pitchDegrees\": -45, \"yawDegrees\": 0 }");

    [Fact, Trait("Category", "Long")]
    public void Search_PanelsPersonAndMarker_AreFoundByTheirClasses()
    {
        var options = new SimulationOptions
        {
            Seed = 3,
            TargetCount = 5,
            DistractorCount = 3,
            TargetKinds =
            [
                SimulatedTargetKind.TwoColouredPanel, SimulatedTargetKind.Person, SimulatedTargetKind.WhitePanel,
                SimulatedTargetKind.AprilTagMarker, SimulatedTargetKind.ColouredPanel,
            ],
        };
        MissionScore score = Fly(SearchFlight.SmallMission, options);

        Assert.Equal(5, score.Targets.Select(t => t.Class).Distinct().Count());
        Check(score, "seed 3");
    }

    /// <summary>
    /// Straight down from 30 m. Measured: all found but one car, nothing else; more seeds in
    /// docs/concepts/simulation.md.
    /// </summary>
    [Fact, Trait("Category", "Long")]
    public void Search_FiveSeedsOfAllKinds_AreFoundByTheirClasses()
    {
        const int Seeds = 5;
        const int MaxMissedCars = 1;
        string mission = SearchFlight.BundledText
            .Replace("\"heightMetres\": 40", "\"heightMetres\": 30")
            .Replace("\"laneSpacingMetres\": 30", "\"laneSpacingMetres\": 22");
        var scores = new MissionScore[Seeds];
        Parallel.For(
            0, Seeds, new ParallelOptions { MaxDegreeOfParallelism = Environment.ProcessorCount },
            index => scores[index] = Fly(
                mission, new SimulationOptions { Seed = index + 1, TargetCount = 8, TargetKinds = AllKinds }));
        for (int i = 0; i < Seeds; i++)
            Check(scores[i], FormattableString.Invariant($"seed {i + 1}"), "car");
        int missed = scores.Sum(s => s.Targets.Count(t => t.Track is null));
        Assert.True(missed <= MaxMissedCars, $"{missed} cars were missed");
    }

    /// <summary>
    /// A camera that is fixed at -45 degrees shows the horizon when the wind tilts the vehicle (seed 11); crates and
    /// jackets in the distance are no targets (seeds 8 and 10). The same seeds and more in docs/concepts/simulation.md.
    /// </summary>
    [Theory, Trait("Category", "Long")]
    [InlineData(8)]
    [InlineData(10)]
    [InlineData(11)]
    public void Search_CameraFixedAt45Degrees_FindsAllKinds(int seed)
    {
        MissionScore score = Fly(
            At45Degrees, new SimulationOptions { Seed = seed, TargetCount = 8, TargetKinds = AllKinds });
        Check(score, FormattableString.Invariant($"seed {seed}"));
    }

    /// <summary>
    /// The same with the markers in the other order, and so at other places: the white cells of an ArUco marker, in
    /// pictures in which it was not read, were a white panel.
    /// </summary>
    [Fact, Trait("Category", "Long")]
    public void Search_CameraFixedAt45DegreesOverAMarker_ItsWhiteCellsAreNoPanel()
    {
        SimulatedTargetKind[] kinds =
            [.. AllKinds.Take(6), SimulatedTargetKind.AprilTagMarker, SimulatedTargetKind.ArUcoMarker];
        MissionScore score = Fly(
            At45Degrees, new SimulationOptions { Seed = 16, TargetCount = 8, TargetKinds = kinds });
        Check(score, "seed 16");
    }

    /// <summary>Half of the panel was taken for a person in four pictures, before PanelHalf.</summary>
    [Fact, Trait("Category", "Long")]
    public void Search_HalfOfAPanelLooksLikeAPersonNowAndThen_IsNoSecondTarget()
    {
        string mission = SearchFlight.BundledText
            .Replace("\"heightMetres\": 40", "\"heightMetres\": 30")
            .Replace("\"laneSpacingMetres\": 30", "\"laneSpacingMetres\": 22");
        MissionScore score = Fly(
            mission, new SimulationOptions { Seed = 13, TargetCount = 8, TargetKinds = AllKinds });
        Check(score, "seed 13");
    }

    private static void Check(MissionScore score, string where, string mayBeMissed = "")
    {
        TargetScore[] found = [.. score.Targets.Where(t => t.Track is not null)];
        Assert.All(
            score.Targets,
            t => Assert.True(t.Track is not null || t.Class.ToString() == mayBeMissed, $"{where}: {t}"));
        Assert.True(score.FalseTracks.Count == 0, $"{where}: {score.FalseTracks.Count} false tracks");
        double rmse = Math.Sqrt(found.Average(t => t.ErrorMetres * t.ErrorMetres));
        Assert.True(rmse <= MaxRmse, $"{where}: RMSE {rmse} m");
    }

    private MissionScore Fly(string mission, SimulationOptions options)
    {
        MissionPlan plan = MissionPlan.Parse(mission, "mixed");
        options.TakePlacesFrom(plan);
        SimulatedTarget[] targets = [.. new SimulatedWorld(options).Targets];
        plan = plan.WithTargets(targets.Select(t => t.Declared).OfType<TargetClass>());
        using var flight = new SearchFlight(plan, options);
        flight.Fly(TimeSpan.FromMinutes(20));
        MissionScore score = flight.Score();
        lock (output)
        {
            output.WriteLine($"seed {options.Seed}: {flight.Mission.Phase}, {flight.Mission.Text}");
            foreach (TargetScore target in score.Targets)
                output.WriteLine("  " + target);
            foreach (TargetTrack track in score.FalseTracks)
                output.WriteLine($"  false: {track.Class} at {track.Position}, {track.Reports} reports");
        }

        Assert.True(
            flight.Mission.Phase == MissionPhase.Done && flight.Mission.Aborted is null,
            $"seed {options.Seed}: {flight.Mission.Text}\n{flight.Log}");
        return score;
    }
}
