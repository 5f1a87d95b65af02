using System;
using Rabit.Geodesy;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Energy;

/// <summary>
/// What the battery cannot fly is not begun, or ends in time; it lands in a field only where it has to.
/// </summary>
public sealed class EnergyFlightTests
{
    [Theory, Trait("Category", "Long")]
    [InlineData(SimulatedAutopilot.ArduPilot, 0)]
    [InlineData(SimulatedAutopilot.Px4, 3)]
    public void Search_FarFromHomeInOtherWinds_LandsAtHomeWithFivePercentLeft(SimulatedAutopilot model, double wind)
        => Search_FarFromHome_LandsAtHomeWithFivePercentLeft(model, wind);

    [Theory]
    [InlineData(SimulatedAutopilot.ArduPilot, 10)]
    public void Search_FarFromHome_LandsAtHomeWithFivePercentLeft(SimulatedAutopilot model, double wind)
    {
        EnergyFlight flight = EnergyFlight.Fly(Far(model) with { Wind = wind });

        EnergyTrialTests.Check(flight);
        Assert.True(flight.WasEndedByEnergy, flight.ToString());
    }

    [Fact]
    public void Search_AgedBatteryAndWindThatRises_LandsAtHomeWithFivePercentLeft()
        => EnergyTrialTests.Check(EnergyFlight.Fly(Far(SimulatedAutopilot.ArduPilot) with
        {
            Speed = 12,
            Wind = 4,
            WindFrom = Angle.FromDegrees(180),
            RisesAt = TimeSpan.FromMinutes(3),
            Capacity = 0.8,
        }));

    [Fact]
    public void Search_BatteryFallsFarFromHome_FliesTowardsHomeAndLandsUnderControl()
    {
        EnergyFlight flight = EnergyFlight.Fly(Far(SimulatedAutopilot.ArduPilot) with
        {
            Faults =
            [
                new ScriptedFault { Kind = ScriptedFaultKind.BatteryTo, At = TimeSpan.FromMinutes(5), Value = 0.2 },
            ],
        });

        Assert.True(flight.Mission.Phase == MissionPhase.Done && !flight.Truth.HasCrashed, flight.ToString());
        Assert.True(flight.Truth.BatteryRemaining > 0, flight.ToString());
        Assert.InRange(flight.LandingDistance, 100, flight.DistanceAtReturn - 500);
        Assert.Contains("home is out of reach", flight.Log, StringComparison.Ordinal);
    }

    [Fact]
    public void Start_PlanThatTheBatteryCannotFly_IsRefusedWithItsFigures()
    {
        EnergyFlight flight = EnergyFlight.Fly(Far(SimulatedAutopilot.ArduPilot) with { AllowsPartial = false });

        Assert.Equal(MissionPhase.Failed, flight.Mission.Phase);
        Assert.False(flight.Truth.HasFlown);
        Assert.Matches(
            @"^the plan takes [0-9.]+ min and [0-9.]+ % of the battery in a wind of 5\.0 m/s, with a reserve of "
                + @"10\.0 %; [0-9.]+ % are left; with allowPartialSearch of the mission, or --allow-partial-search, "
                + "it is begun, and returns in time$",
            flight.Mission.Text);
    }

    // Findings: 4.4 km from home at 15 m/s.
    private static EnergyCase Far(SimulatedAutopilot model) => new(1, model)
    {
        Distance = 4200,
        Speed = 15,
        WindFrom = Angle.FromDegrees(60),
    };
}
