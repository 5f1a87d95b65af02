using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>
/// Flights in which nothing goes wrong: no rule of Health Monitoring finds anything. With small pictures, from a height
/// at which they are fine enough; <see cref="SearchTests"/> flies with those of a real camera.
/// </summary>
public sealed class NominalHealthTests
{
    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void Flight_NothingGoesWrong_NothingIsFound(SimulatedAutopilot model)
        => Assert.Empty(FindingsOf(model, seed: 5, SearchFlight.SmallPlan()));

    [Theory, Trait("Category", "Long")]
    [InlineData(SimulatedAutopilot.ArduPilot)]
    [InlineData(SimulatedAutopilot.Px4)]
    public void Flight_SeedsOneToForty_NothingIsFound(SimulatedAutopilot model)
        => Assert.Empty(Enumerable.Range(1, 40).AsParallel().AsOrdered()
            .SelectMany(seed => FindingsOf(model, seed, SearchFlight.SmallPlan())));

    private static List<string> FindingsOf(SimulatedAutopilot model, long seed, MissionPlan plan)
    {
        SimulationOptions options = SearchFlight.SmallWorld();
        (options.Autopilot, options.Seed) = (model, seed);
        using var flight = new SearchFlight(plan, options);
        var findings = new List<string>();
        flight.FlyUntil(
            f =>
            {
                bool isFlying = f.Mission.Phase is not (MissionPhase.NoMission or MissionPhase.WaitingForVehicle);
                string text = FormattableString.Invariant($"{model}, seed {seed}: {f.Health.Text}");
                if (isFlying && f.Health.Reasons != HealthReasons.None && !findings.Contains(text))
                    findings.Add(text);
                return f.IsOver;
            },
            TimeSpan.FromMinutes(20));
        flight.End();
        if (flight.Mission.Phase != MissionPhase.Done)
            findings.Add(FormattableString.Invariant($"{model}, seed {seed}: {flight.Mission.Text}"));
        return findings;
    }
}
