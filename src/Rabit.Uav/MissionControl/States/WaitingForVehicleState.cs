using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// Waits until the vehicle is connected, healthy, on the ground and has a position, all of it for some time. Of a fixed
/// wing it then waits until its pilot has taken off and given it over.
/// </summary>
internal sealed class WaitingForVehicleState() : MissionState(MissionPhase.WaitingForVehicle)
{
    // All conditions must hold for so long: the first messages of a vehicle come in any order.
    private static readonly TimeSpan MinReadyTime = TimeSpan.FromSeconds(2);
    private static readonly TimeSpan MaxGpsAge = TimeSpan.FromSeconds(5);

    private TimeSpan? _readySince;
    private bool _isPilotAwaited;

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase)
    {
        flight.Changes.BeginLeg();
        if (_isPilotAwaited)
            return AwaitPilot(flight);
        if (flight.IsFlying)
        {
            if (flight.Options.Resume is not null && flight.Plan is null)
                flight.PlanInFlight();
            return new MissionStep(
                MissionEvent.AlreadyFlying,
                "the vehicle is already flying; only the operator's hold or return commands it");
        }

        if (flight.IsConnected && flight.IsFixedWing && FixedWingRules.FindFault(flight) is { } notFlown)
            return Impossible(notFlown);
        string? missing = FindMissing(flight);
        flight.Text = "waiting: " + (missing ?? "ready");
        if (missing is not null)
        {
            _readySince = null;
            return inPhase > flight.Options.ReadyTimeout
                ? Impossible($"not ready within {MissionNumbers.Seconds(flight.Options.ReadyTimeout)}: {missing}")
                : MissionStep.Stay;
        }

        _readySince ??= flight.Now;
        if (flight.Now - _readySince.Value < MinReadyTime)
            return MissionStep.Stay;
        string fault = flight.CreatePlan();
        if (fault.Length > 0)
            return Impossible(fault);
        if (flight.Group?.IsSearched(flight) == true)
            return Impossible("the others have searched the area; nothing is left to fly for");
        if (!flight.IsFixedWing)
            return new MissionStep(MissionEvent.Ready, PlanText(flight));
        flight.MeasureGround();
        flight.Log($"ready, {PlanText(flight)}: its pilot takes off; targets are not revisited");
        (_isPilotAwaited, _readySince) = (true, null);
        return MissionStep.Stay;
    }

    // A mode that is passed through gives nothing over.
    private MissionStep AwaitPilot(MissionFlight flight)
    {
        string? missing = !flight.IsConnected ? "no autopilot connected"
            : !flight.IsFlying ? "ready: its pilot takes off"
            : FixedWingRules.FindMissing(flight)
                ?? (flight.Health.Advice == HealthAdvice.None && flight.Health.Level != HealthLevel.Critical
                    ? null
                    : flight.Health.AdviceText ?? flight.Health.Text ?? "health advises against it");
        flight.Text = "waiting: " + (missing ?? "given over");
        _readySince = missing is null ? _readySince ?? flight.Now : null;
        return flight.Now - _readySince >= MinReadyTime
            ? new MissionStep(MissionEvent.GivenOver, $"its pilot gave it over in {flight.Vehicle.Mode}")
            : MissionStep.Stay;
    }

    private static string PlanText(MissionFlight flight)
        => $"{MissionNumbers.Of(flight.Route!.Count)} lanes over {MissionNumbers.Of(flight.Plan!.Area.Area)} m2"
                + (flight.Options.Resume is null
                    ? string.Empty
                    : $", {MissionNumbers.Of(flight.Route.Flown)} of them flown already, "
                        + MissionNumbers.Percent(flight.Route.Coverage.Fraction) + " seen");

    private static string? FindMissing(MissionFlight flight)
    {
        if (!flight.IsConnected)
            return "no autopilot connected";
        if (flight.Authority.State == CommandAuthorityState.Observing)
            return "we only observe, and may not command";
        if (!flight.HasFreshPosition)
            return "no position";
        if (flight.Options.RequiresPreflight && flight.Preflight.FindRefusal() is { } refusal)
            return refusal;

        if (flight.Group?.FindConflict(flight) is { } conflict)
            return conflict;
        if (FindShortage(flight) is { } shortage)
            return shortage;

        // Where there is a checklist it judges these, and the operator may override a line of it.
        if (!flight.Options.RequiresPreflight && FindMissingOfVehicle(flight) is { } missing)
            return missing;
        if ((flight.Health.Reasons & ReasonsToWait(flight.Mission)) != 0)
            return flight.Health.Text ?? "health advises against it";
        return flight.Health.Level switch
        {
            HealthLevel.Unknown => "health unknown",
            HealthLevel.Critical => flight.Health.Text ?? "health critical",
            _ => flight.Health.Advice != HealthAdvice.None ? flight.Health.Text ?? "health advises against it" : null,
        };
    }

    // In flight they are reasons to return or to hold; before it there is no advice, and what passes is waited for.
    private static HealthReasons ReasonsToWait(MissionPlan mission)
        => mission.GroundStationLost is { HoldAfter: null, ReturnAfter: null }
            ? HealthReasons.WindHigh
            : HealthReasons.WindHigh | HealthReasons.GroundStationLost;

    private static string? FindMissingOfVehicle(MissionFlight flight)
    {
        VehicleState vehicle = flight.Vehicle;
        if (vehicle.GpsFix < GpsFixType.Type3dFix || !(flight.Now - vehicle.GpsTime <= MaxGpsAge))
            return "no satellite fix";
        bool isKnown = vehicle.BatteryTime is not null && !double.IsNaN(vehicle.BatteryRemaining);
        if (!isKnown && !flight.Mission.AllowUnknownBattery)
            return "the charge of the battery is not known (limits.allowUnknownBattery of the mission)";
        return flight.Options.RequiresCamera && !flight.Imaging.HasCamera ? "no camera" : null;
    }

    // Of a checklist that is what the mission file says; the operator may have asked for more since. Comparisons with
    // NaN are false.
    private static string? FindShortage(MissionFlight flight)
    {
        double remaining = flight.Vehicle.BatteryRemaining;
        double needed = flight.Mission.MinBatteryFractionAtStart;
        bool isChecked = flight.Options.RequiresPreflight
            && needed <= (flight.Options.Mission ?? flight.Mission).MinBatteryFractionAtStart;
        return !isChecked && remaining < needed
            ? $"battery {MissionNumbers.Percent(remaining)}; {MissionNumbers.Percent(needed)} are needed"
            : null;
    }
}
