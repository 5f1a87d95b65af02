using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Rabit.Tests.Shared;
using Rabit.Uav.Messages;
using Rabit.Uav.Simulation.Tests.FaultMatrix;
using Xunit;
using Xunit.Abstractions;

namespace Rabit.Uav.Simulation.Tests.TakeoverTrials;

/// <summary>
/// The pilot's mode stands: at random moments of whole flights, and right beside our own mode commands.
/// </summary>
public sealed class TakeoverTrialTests(ITestOutputHelper output)
{
    // Of those beside our own commands, what the real ones lost: ArduPilot none, PX4 11 of 100.
    private const double MaxLostOnPx4 = 0.11;
    // The real ones were tried on one computer with the companion.
    private static readonly TimeSpan RaceLatency = TimeSpan.Zero;

    private const double MinStanding = 0.99;
    private const int TrialsPerModel = 100;

    // The switch is debounced for 0.2 s, so that it cannot be aimed at a moment.
    private static readonly string[] ArdupilotModes = ["LOITER", "BRAKE", "POSHOLD", "ALT_HOLD"];
    private static readonly string[] Px4Modes = ["AUTO.LOITER", "POSCTL"];

    [Theory, Trait("Category", "Long")]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void Pilot_RandomMoments_ModeStands(SimulatedAutopilot model)
        => CheckRandom(FlyAll(RandomMoments(model, seed: 1, TrialsPerModel)));

    [Theory, Trait("Category", "Long")]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void Pilot_WithinATenthOfASecondOfOurModeCommand_IsLostNoMoreThanOnTheRealOnes(SimulatedAutopilot model)
        => CheckRaces(model, FlyAll(Races(model, seed: 2, TrialsPerModel)));

    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void Pilot_AFewRandomMoments_ModeStands(SimulatedAutopilot model)
        => CheckRandom(FlyAll(RandomMoments(model, seed: 3, count: 2)));   // ArduPilot: one by the switch, one not

    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void Pilot_AFewMomentsBesideOurModeCommand_NothingIsSentAfterAReportShowsHisMode(SimulatedAutopilot model)
    {
        foreach (TakeoverTrial trial in FlyAll(Races(model, seed: 4, count: 2)))
            Assert.True(trial.SentAfterReport is null, trial.ToString());
    }

    private static string[] ModesOf(SimulatedAutopilot model)
        => model == SimulatedAutopilot.Px4 ? Px4Modes : ArdupilotModes;

    // From the middle of the take-off to the middle of the landing; a third of ArduPilot's by the switch.
    private static List<Func<TakeoverTrial>> RandomMoments(SimulatedAutopilot model, int seed, int count)
    {
        var random = new SeededNumbers(seed);
        var trials = new List<Func<TakeoverTrial>>();
        for (int index = 0; index < count; index++)
        {
            long flight = FaultMatrixCells.Seeds[index % FaultMatrixCells.Seeds.Length];
            double part = random.Uniform();
            string mode = Pick(random, ModesOf(model));
            bool bySwitch = model == SimulatedAutopilot.ArduPilot && index % 3 == 0;
            trials.Add(() =>
            {
                NominalTimeline nominal = NominalTimeline.Of(model, flight);
                double from = nominal.TimeOf(MissionPhase.TakingOff).TotalSeconds;
                double to = nominal.TimeOf(MissionPhase.Landing).TotalSeconds;
                TimeSpan at = TimeSpan.FromSeconds(Math.Round(from + (part * (to - from)), 3));
                return TakeoverTrial.Fly(model, flight, at, mode, bySwitch);
            });
        }

        return trials;
    }

    // Mode commands of a first run of the same seed; in flight, so not arming.
    private static List<Func<TakeoverTrial>> Races(SimulatedAutopilot model, int seed, int count)
    {
        var random = new SeededNumbers(seed);
        long[] flights = FaultMatrixCells.Seeds.Take(Math.Max(1, Math.Min(count / 10, 3))).ToArray();
        var moments = new List<(long Flight, TimeSpan At)>();
        foreach (long flight in flights)
        {
            TimeSpan up = NominalTimeline.Of(model, flight).TimeOf(MissionPhase.TakingOff);
            moments.AddRange(
                TakeoverTrial.ModeCommandTimes(model, flight, RaceLatency).Where(t => t > up).Select(t => (flight, t)));
        }

        var trials = new List<Func<TakeoverTrial>>();
        for (int index = 0; index < count; index++)
        {
            (long flight, TimeSpan at) = moments[index % moments.Count];
            TimeSpan moment = at + TimeSpan.FromMilliseconds(Math.Round((random.Uniform() * 200) - 100, 1));
            string mode = Pick(random, ModesOf(model));
            trials.Add(() => TakeoverTrial.Fly(model, flight, moment, mode, bySwitch: false, RaceLatency));
        }

        return trials;
    }

    private static string Pick(SeededNumbers random, string[] modes)
        => modes[random.Below(modes.Length)];

    private static TakeoverTrial[] FlyAll(List<Func<TakeoverTrial>> trials)
    {
        var results = new ConcurrentDictionary<int, TakeoverTrial>();
        Parallel.For(
            0, trials.Count, new ParallelOptions { MaxDegreeOfParallelism = Environment.ProcessorCount },
            index => results[index] = trials[index]());
        return results.OrderBy(r => r.Key).Select(r => r.Value).ToArray();
    }

    private void CheckRandom(TakeoverTrial[] trials)
    {
        Write(trials);
        Assert.True(trials.Count(t => t.Stands) >= MinStanding * trials.Length, Lost(trials));
        Assert.All(trials, t => Assert.True(t.SentAfterReport is null, t.ToString()));
    }

    private void CheckRaces(SimulatedAutopilot model, TakeoverTrial[] trials)
    {
        Write(trials);
        double maxLost = model == SimulatedAutopilot.Px4 ? MaxLostOnPx4 * trials.Length : 0;
        Assert.True(trials.Count(t => !t.Stands) <= maxLost, Lost(trials));
        Assert.All(trials, t => Assert.True(t.SentAfterReport is null, t.ToString()));
    }

    private void Write(TakeoverTrial[] trials)
    {
        foreach (TakeoverTrial trial in trials)
            output.WriteLine(trial.ToString());
        output.WriteLine($"{trials.Length} trials, {trials.Count(t => !t.Stands)} lost");
    }

    private static string Lost(TakeoverTrial[] trials)
        => string.Join("\n", trials.Where(t => !t.Stands).Select(t => t.ToString()));
}
