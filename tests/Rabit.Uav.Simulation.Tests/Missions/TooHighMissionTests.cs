using System;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>A mission from a height at which no picture could be searched.</summary>
public sealed class TooHighMissionTests
{
    [Fact]
    public void Mission_TooHighForItsSmallestTarget_DoesNotTakeOffAndSaysWhatWouldDo()
    {
        var plan = MissionPlan.Parse(
            SearchFlight.SmallMission.Replace("\"heightMetres\": 30", "\"heightMetres\": 90"), "high");
        using var flight = new SearchFlight(plan, SearchFlight.SmallWorld());
        flight.FlyUntil(f => f.IsOver, TimeSpan.FromSeconds(60));

        Assert.True(flight.Mission.Phase == MissionPhase.WaitingForVehicle, flight.Mission.Phase + flight.Log);
        Assert.Contains("resolution", flight.Mission.Text);
        Assert.True(
            flight.Log.Contains("red of 0.6 m: 1.7 pixels from 90 m; 4.0 are needed, as from 37 m"), flight.Log);
        Assert.Equal(0, flight.Imaging.Observations);
    }
}
