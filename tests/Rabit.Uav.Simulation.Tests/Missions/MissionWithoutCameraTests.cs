using System;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav.Messages;
using Xunit;

namespace Rabit.Uav.Simulation.Tests.Missions;

/// <summary>A mission without a camera, by the options of Mission Control.</summary>
public sealed class MissionWithoutCameraTests
{
    [Theory]
    [InlineData(false, true)]
    [InlineData(true, false)]
    public void Mission_NoCamera_TakesOffOnlyWhereItRequiresNone(bool requiresCamera, bool takesOff)
    {
        SimulationOptions simulation = SearchFlight.SmallWorld();
        var time = new VirtualTime(simulation.Seed);
        var options = new UavOptions { Mission = SearchFlight.SmallPlan(), MayCommand = true, Time = time };
        options.MissionControl.RequiresCamera = requiresCamera;
        simulation.TakePlacesFrom(options.Mission);
        var world = new SimulatedWorld(simulation);
        var link = new MemoryLinkPair("simulation");
        options.OpenLinks = [link.A];
        using UavSystem uav = UavSystem.Open(options);
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions { StopsOnSignals = false });
        reactor.Add(world.CreateVehicle(link.B));
        MessageSubscriber<VehicleState> vehicle = reactor.Workspace.Subscribe<VehicleState>(MessageNames.VehicleState);

        reactor.Start();
        reactor.RunFor(TimeSpan.FromSeconds(120));
        vehicle.Fetch();
        bool isInTheAir = vehicle.Value.HeightAboveHomeMetres > 10;
        reactor.Stop("the test is over");
        reactor.Finish();

        Assert.Equal(takesOff, isInTheAir);
    }
}
