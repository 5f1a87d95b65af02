using System;
using System.Text;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Simulation.Tests.Energy;

/// <summary>A flight of the energy trial without pictures, and what came of it.</summary>
internal sealed class EnergyFlight
{
    private static readonly TimeSpan AtMost = TimeSpan.FromMinutes(60);

    private EnergyFlight(EnergyCase drawn, MissionStatus mission, SimulatedTruth truth, string log)
        => (Case, Mission, Truth, Log) = (drawn, mission, truth, log);

    public EnergyCase Case { get; }

    public MissionStatus Mission { get; }

    public SimulatedTruth Truth { get; }

    public string Log { get; }

    /// <summary>What Mission Control published when the vehicle began to return.</summary>
    public EnergyStatus AtReturn { get; private set; }

    /// <summary>What was truly left then.</summary>
    public double LeftAtReturn { get; private set; }

    /// <summary>How far from home that was, metres.</summary>
    public double DistanceAtReturn { get; private set; }

    public bool WasEndedByEnergy
        => Mission.Aborted?.IndexOf("needed for the way home", StringComparison.Ordinal) >= 0;

    public double LandingDistance => Truth.Landing is { } landing
        ? landing.Position.HorizontalDistanceTo(NedPosition.Origin)
        : double.NaN;

    public static EnergyFlight Fly(EnergyCase drawn)
    {
        SimulationOptions simulation = drawn.World();
        MissionPlan plan = drawn.Plan();
        simulation.TakePlacesFrom(plan);
        var time = new VirtualTime(drawn.Seed);
        var options = new UavOptions { Mission = plan, MayCommand = true, Time = time };
        options.MissionControl.RequiresCamera = false;
        options.MissionControl.MaxGapPasses = 0;
        options.MissionControl.Energy.MaxAirspeedMetresPerSecond = 18;

        // Gusts of a mean of 10 m/s: the wind is to end none of these flights.
        options.Health = new HealthOptions { WindHighMetresPerSecond = 18, GustHighMetresPerSecond = 25 };
        var world = new SimulatedWorld(simulation);
        var link = new MemoryLinkPair("simulation");
        options.OpenLinks = [link.A];
        using UavSystem uav = UavSystem.Open(options);
        var log = new StringBuilder();
        RabitReactor reactor = uav.CreateReactor(
            new ReactorOptions { StopsOnSignals = false, Log = e => log.Append(e).Append('\n') });
        reactor.Add(world.CreateVehicle(link.B));
        MessageSubscriber<MissionStatus> mission
            = reactor.Workspace.Subscribe<MissionStatus>(MessageNames.Mission);
        EnergyStatus? atReturn = null;
        double leftAtReturn = 0;
        double distanceAtReturn = 0;
        reactor.Start();
        while (reactor.Now < AtMost && reactor.RunFor(TimeSpan.FromSeconds(1)))
        {
            mission.Fetch();
            MissionPhase phase = mission.Value.Phase;
            if (phase is MissionPhase.Returning or MissionPhase.HandedOver && atReturn is null)
            {
                SimulatedTruth truth = world.Truth;
                (atReturn, leftAtReturn) = (mission.Value.Energy, truth.BatteryRemaining);
                distanceAtReturn = truth.Pose.Position.HorizontalDistanceTo(NedPosition.Origin);
            }

            bool isHandedOver = phase == MissionPhase.HandedOver && !world.Truth.IsAirborne;
            if (phase is MissionPhase.Done or MissionPhase.Failed || isHandedOver)
                break;
        }

        reactor.Stop("the flight is over");
        reactor.Finish();
        mission.Fetch();
        return new EnergyFlight(drawn, mission.Value, world.Truth, log.ToString())
        {
            AtReturn = atReturn ?? default,
            LeftAtReturn = leftAtReturn,
            DistanceAtReturn = distanceAtReturn,
        };
    }

    public override string ToString()
        => FormattableString.Invariant(
            $"{Case}: {Mission.Phase}, landed {LandingDistance:0.0} m from home with {Truth.BatteryRemaining:0.000} left after {Truth.Airtime.TotalSeconds:0} s; {(WasEndedByEnergy ? "by energy" : Mission.Aborted ?? Mission.Text)}; at return {DistanceAtReturn:0} m out: left {LeftAtReturn:0.000}, estimated {AtReturn.ChargeLeft:0.000} +- {AtReturn.ChargeLeftDeviation:0.000}, capacity {AtReturn.CapacityFraction:0.00}, home {AtReturn.ChargeHome:0.000} +- {AtReturn.ChargeHomeDeviation:0.000}, hover {AtReturn.HoverWatts:0} W, cruise {AtReturn.CruiseWatts:0} W, home in {AtReturn.TimeHome.TotalSeconds:0} s");
}
