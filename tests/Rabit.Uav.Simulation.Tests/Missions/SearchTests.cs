using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>
/// The simulated search that UavConsole flies without arguments, from arming to landing; its own tests fly seed 1 each
/// time.
/// </summary>
public sealed class SearchTests(ITestOutputHelper output)
{
    private const double MaxRmse = 3;
    private const double MaxHalfAxis = 8;

    // Of the pictures of a flight without faults.
    private const double MinUsable = 0.98;

    // The tests of UavConsole compare two flights of one seed each time.
    [Fact, Trait("Category", "Long")]
    public void Search_SameSeed_GivesTheSameLogToTheByte()
    {
        string first = LogOf(seed: 3);
        Assert.Equal(first, LogOf(seed: 3));
        Assert.NotEqual(first, LogOf(seed: 4));
    }

    [Theory, Trait("Category", "Long")]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void Search_FortySeeds_AreAsGoodAsTheySay(SimulatedAutopilot model)
    {
        const int Seeds = 40;
        var flights = new List<TargetScore>[Seeds];
        Parallel.For(
            0, Seeds, new ParallelOptions { MaxDegreeOfParallelism = Environment.ProcessorCount },
            index => flights[index] = Fly(index + 1, model));
        List<TargetScore> scores = flights.SelectMany(f => f).ToList();

        double rmse = Rmse(scores);
        double inEllipse = scores.Count(s => s.EllipseContainsTruth) / (double)scores.Count;
        output.WriteLine(FormattableString.Invariant(
            $"all: RMSE {rmse:0.00} m, {inEllipse:P0} in their ellipses, largest half axis {scores.Max(s => s.Track!.Covariance.HalfMajorAxis95Metres):0.00} m"));
        Assert.True(rmse <= MaxRmse, $"RMSE {rmse} m");
        Assert.InRange(inEllipse, 0.85, 1);
    }

    private List<TargetScore> Fly(long seed, SimulatedAutopilot model = SimulatedAutopilot.ArduPilot)
    {
        using var flight = new SearchFlight(
            SearchFlight.BundledPlan(), new SimulationOptions { Seed = seed, Autopilot = model });
        flight.Fly(TimeSpan.FromMinutes(20));
        MissionScore score = flight.Score();
        List<TargetScore> scores = score.Targets.ToList();
        TruePose landing = flight.World.Truth.Landing ?? default;
        double fromHome = Math.Sqrt(
            (landing.Position.North * landing.Position.North) + (landing.Position.East * landing.Position.East));
        output.WriteLine(FormattableString.Invariant(
            $"{model}, seed {seed}: {flight.Mission.Phase} at {flight.Reactor.Now}, {flight.Mission.Coverage:P1} seen, landed {fromHome:0.00} m from home, RMSE {Rmse(scores):0.00} m"));
        foreach (TargetScore target in scores)
            output.WriteLine("  " + target);

        string where = $"{model}, seed {seed}: ";
        Assert.True(
            flight.Mission.Phase == MissionPhase.Done && flight.Mission.Aborted is null,
            where + flight.Mission.Text + "\n" + flight.Log);
        Assert.All(scores, s => Assert.True(s.Track is not null, where + s));
        Assert.All(scores, s => Assert.True(s.Track!.Covariance.HalfMajorAxis95Metres <= MaxHalfAxis, where + s));
        Assert.True(score.FalseTracks.Count == 0, $"{where}{score.FalseTracks.Count} false tracks");
        Assert.True(Rmse(scores) <= MaxRmse, $"{where}RMSE {Rmse(scores)} m");
        Assert.True(flight.Mission.Coverage >= 0.98, $"{where}{flight.Mission.Coverage} seen");
        Assert.True(flight.World.Truth.Landing is not null && fromHome <= 3, $"{where}landed {fromHome} m from home");
        PictureCounts pictures = flight.Imaging.Pictures;
        output.WriteLine(FormattableString.Invariant(
            $"  {pictures.Usable} of {pictures.Total} pictures usable, {flight.Imaging.LastRefusal}"));
        Assert.True(
            pictures.Usable >= MinUsable * pictures.Total,
            FormattableString.Invariant($"{where}{pictures.Usable} of {pictures.Total} pictures usable"));
        string[] alarms = flight.Log.Split('\n').Where(line => line.Contains("health: pictures")).ToArray();
        Assert.True(alarms.Length == 0, where + string.Join("\n", alarms));
        Assert.Empty(flight.Camera.BufferHolders());
        return scores;
    }

    private static string LogOf(long seed)
    {
        SimulationOptions world = SearchFlight.SmallWorld();
        (world.Seed, world.TargetCount, world.DistractorCount) = (seed, 3, 2);
        using var flight = new SearchFlight(SearchFlight.SmallPlan(), world);
        flight.Fly(TimeSpan.FromMinutes(10));
        return flight.Log
            + string.Join("\n", flight.Tracks.Tracks.Select(
                t => FormattableString.Invariant(
                    $"{t.Id} {t.Position.Latitude.Radians:R} {t.Position.Longitude.Radians:R} {t.Reports}")));
    }

    private static double Rmse(IReadOnlyCollection<TargetScore> scores)
        => Math.Sqrt(scores.Average(s => s.ErrorMetres * s.ErrorMetres));
}
