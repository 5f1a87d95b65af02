using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Until the vehicle is heard, healthy, on the ground and knows where it is, for a while.</summary>
internal sealed class WaitingForVehicleState() : MissionState(MissionPhase.WaitingForVehicle)
{
    // So long all must be well before the mission begins: the first words of a vehicle come in any order.
    private static readonly TimeSpan SteadyFor = TimeSpan.FromSeconds(2);
    private static readonly TimeSpan GpsAge = TimeSpan.FromSeconds(5);

    private TimeSpan? _readySince;

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        if (flight.IsFlying)
            return Impossible("the vehicle is flying already; it is not taken over");
        string? missing = WhatIsMissing(flight);
        flight.Text = "waiting: " + (missing ?? "all is well");
        if (missing is not null)
        {
            _readySince = null;
            return inPhase > flight.Options.ReadyWithin
                ? Impossible($"not ready within {MissionText.Seconds(flight.Options.ReadyWithin)}: {missing}")
                : MissionStep.Stay;
        }

        _readySince ??= flight.Now;
        if (flight.Now - _readySince.Value < SteadyFor)
            return MissionStep.Stay;
        string fault = flight.MakePlan();
        if (fault.Length > 0)
            return Impossible(fault);
        return new MissionStep(MissionEvent.Ready, $"{MissionText.Of(flight.Route!.Count)} lanes over {MissionText.Of(flight.Plan!.Area.Area)} m2");
    }

    private static string? WhatIsMissing(MissionFlight flight)
    {
        VehicleState vehicle = flight.Vehicle;
        if (!flight.IsHeard)
            return "no autopilot heard";
        if (flight.Authority.State == CommandAuthorityState.Observing)
            return "we only observe, and may not command";
        if (!flight.KnowsWhereItIs)
            return "no position";
        if (vehicle.GpsFix < GpsFixType.Type3dFix || !(flight.Now - vehicle.GpsTime <= GpsAge))
            return "no satellite fix";
        if (vehicle.BatteryRemaining < flight.Mission.MinBatteryToStart)
            return $"battery {MissionText.Percent(vehicle.BatteryRemaining)}; {MissionText.Percent(flight.Mission.MinBatteryToStart)} are needed";
        if (flight.Options.RequiresCamera && !flight.Imaging.HasCamera)
            return "no camera";
        return flight.Health.Level switch
        {
            HealthLevel.Unknown => "health not known",
            HealthLevel.Critical => flight.Health.Text ?? "health critical",
            _ when flight.Health.Advice != HealthAdvice.None => flight.Health.Text ?? "health advises against it",
            _ => null,
        };
    }
}
