using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav;
using Rabit.Uav.Messages;
using Rabit.Uav.Simulation;
using Xunit;

namespace UavConsole.Tests.Abandoned;

/// <summary>The request to return, against the simulated vehicle.</summary>
public sealed class AbandonedFlightTests
{
    [Fact]
    public void Run_HoversInGuided_IsAskedOnceAndReturns()
    {
        (AbandonedReturnManager manager, VehicleState vehicle, int requests) = Fly(startsAt: 60);

        Assert.Equal(("asked to return: Accepted", true), (manager.Outcome, manager.IsInOrder));
        Assert.Equal(1, requests);
        Assert.True(vehicle.IsArmed);
    }

    [Fact]
    public void Run_OnTheGround_NothingIsSent()
    {
        (AbandonedReturnManager manager, _, int requests) = Fly(startsAt: 0);

        Assert.Equal(("the vehicle is not armed; nothing is sent", true), (manager.Outcome, manager.IsInOrder));
        Assert.Equal(0, requests);
    }

    [Fact]
    public void Run_PilotHasTakenOver_NothingIsSent()
    {
        (AbandonedReturnManager manager, VehicleState vehicle, int requests) = Fly(
            startsAt: 60,
            new ScriptedFault
            {
                Kind = ScriptedFaultKind.PilotMode,
                At = TimeSpan.FromSeconds(50),
                Value = 5,
            });

        Assert.Equal("its mode is LOITER: another commands it; nothing is sent", manager.Outcome);
        Assert.Equal((0, "LOITER"), (requests, vehicle.Mode));
    }

    [Fact]
    public void Run_NoVehicle_EndsAndSaysSo()
    {
        (AbandonedReturnManager manager, _, int requests) = Fly(
            startsAt: 60,
            new ScriptedFault
            {
                Kind = ScriptedFaultKind.LinkSilent,
                At = TimeSpan.FromSeconds(40),
                Duration = TimeSpan.FromHours(1),
            });

        Assert.Equal(("no report of the vehicle; nothing is sent", false), (manager.Outcome, manager.IsInOrder));
        Assert.Equal(0, requests);
    }

    private static (AbandonedReturnManager Manager, VehicleState Vehicle, int Requests) Fly(
        double startsAt, params ScriptedFault[] faults)
    {
        var world = new SimulatedWorld(new SimulationOptions { Seed = 3, Faults = faults });
        var link = new MemoryLinkPair("vehicle");
        var manager = new AbandonedReturnManager(TimeSpan.FromSeconds(startsAt));
        using UavSystem uav = UavSystem.Open(new UavOptions
        {
            OpenLinks = [link.A],
            MayCommand = true,
            OtherManagers = [world.CreateVehicle(link.B), new LiftManager(), manager],
            Time = new VirtualTime(3),
        });
        var requests = new List<string>();
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions
        {
            StopsOnSignals = false,
            Log = e => requests.AddRange(
                new[] { e.ToString() }.Where(t => t.Contains("asked the vehicle to return", StringComparison.Ordinal))),
        });
        MessageSubscriber<VehicleState> vehicle = reactor.Workspace.Subscribe<VehicleState>(MessageNames.VehicleState);
        reactor.Start();
        while (reactor.Now < TimeSpan.FromSeconds(120) && reactor.RunFor(TimeSpan.FromSeconds(1)))
        {
            vehicle.Fetch();
        }

        reactor.Stop("the test is over");
        reactor.Finish();
        return (manager, vehicle.Value, requests.Count);
    }
}
