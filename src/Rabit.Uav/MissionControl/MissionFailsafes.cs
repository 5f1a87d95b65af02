using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>The failsafes: checked in every phase before the phase itself, the most severe first.</summary>
internal sealed class MissionFailsafes
{
    // Motors that stop below this height have landed.
    private const double LandedHeightMetres = 5;

    // A single position outside may be an outlier.
    private static readonly TimeSpan MaxTimeOutside = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan MaxTimeOnGround = TimeSpan.FromSeconds(3);
    private static readonly TimeSpan MaxDisconnection = TimeSpan.FromMinutes(5);
    private static readonly TimeSpan MaxTimeWithoutPosition = TimeSpan.FromSeconds(15);

    private TimeSpan? _disconnectedSince;
    private TimeSpan? _noPositionSince;
    private TimeSpan? _outsideSince;
    private TimeSpan? _onGroundSince;

    /// <summary>Command authority: checked even while no autopilot is connected.</summary>
    public static MissionStep CheckAuthority(MissionFlight flight)
    {
        if (flight.Authority.State == CommandAuthorityState.TakenAway)
            return new MissionStep(
                MissionEvent.TakenOver, flight.Authority.TakenBy ?? "the pilot or the autopilot took over");
        if (flight.Commands.NotInCommand is not { } why)
            return MissionStep.Stay;
        return flight.Authority.State == CommandAuthorityState.Observing
            ? new MissionStep(MissionEvent.Impossible, "we only observe: " + why)
            : new MissionStep(MissionEvent.TakenOver, why);
    }

    /// <summary>Whether the vehicle can be commanded: an autopilot is connected and has a position.</summary>
    /// <param name="flight">The state of the mission.</param>
    /// <param name="canAct">Whether the vehicle can be commanded.</param>
    public MissionStep CheckConnection(MissionFlight flight, out bool canAct)
    {
        _disconnectedSince = flight.IsConnected ? null : _disconnectedSince ?? flight.Now;
        _noPositionSince = flight.IsConnected && !flight.HasFreshPosition ? _noPositionSince ?? flight.Now : null;
        canAct = flight.IsConnected && flight.HasFreshPosition;
        if (_disconnectedSince is { } since)
        {
            flight.Text = "autopilot not connected";
            if (flight.Plan is not null && flight.Now - since > MaxDisconnection)
                return new MissionStep(
                    MissionEvent.Impossible, $"no autopilot for {MissionNumbers.Seconds(MaxDisconnection)}");
        }
        else if (_noPositionSince is { } lost)
        {
            flight.Text = "no position";
            if (flight.Now - lost > MaxTimeWithoutPosition && flight.IsFlying)
                return new MissionStep(
                    MissionEvent.LandNow, $"no position for {MissionNumbers.Seconds(MaxTimeWithoutPosition)}");
        }

        return MissionStep.Stay;
    }

    /// <summary>What ends a phase from outside; only while the vehicle can be commanded.</summary>
    public MissionStep Check(MissionFlight flight, MissionPhase phase, string? abort)
    {
        if (IsBeforeTakeOff(flight, phase))
            return CheckBeforeTakeOff(flight, phase, abort);
        MissionStep motors = CheckMotors(flight, phase);
        if (motors.What != MissionEvent.None)
            return motors;
        if (flight.Health.Advice == HealthAdvice.Land)
            return new MissionStep(MissionEvent.LandNow, Advice(flight));
        if (abort is not null)
            return new MissionStep(MissionEvent.ReturnToLaunch, abort);
        if (flight.Health.Advice == HealthAdvice.ReturnToLaunch)
            return new MissionStep(MissionEvent.ReturnToLaunch, Advice(flight));
        return CheckFence(flight);
    }

    private static string Advice(MissionFlight flight)
        => "health: " + (flight.Health.AdviceText ?? flight.Health.Text ?? "no reason given");

    private static bool IsBeforeTakeOff(MissionFlight flight, MissionPhase phase)
        => phase is MissionPhase.WaitingForVehicle or MissionPhase.Arming
            || (phase == MissionPhase.TakingOff && !flight.IsFlying);

    private static MissionStep CheckBeforeTakeOff(MissionFlight flight, MissionPhase phase, string? abort)
    {
        if (abort is not null)
            return new MissionStep(MissionEvent.Impossible, "given up before take-off: " + abort);
        return phase != MissionPhase.WaitingForVehicle && flight.Health.Advice != HealthAdvice.None
            ? new MissionStep(MissionEvent.Impossible, "given up before take-off: " + Advice(flight))
            : MissionStep.Stay;
    }

    private MissionStep CheckMotors(MissionFlight flight, MissionPhase phase)
    {
        bool isLanding = phase is MissionPhase.Returning or MissionPhase.Landing;
        if (!flight.Vehicle.IsArmed && (!isLanding || flight.HeightMetres > LandedHeightMetres))
        {
            return new MissionStep(
                MissionEvent.Impossible,
                $"the motors stopped at a height of {MissionNumbers.Of(flight.HeightMetres)} m");
        }

        bool isOnGround = flight.Vehicle.LandedState == MavLandedState.OnGround && !isLanding;
        _onGroundSince = isOnGround ? _onGroundSince ?? flight.Now : null;
        return flight.Now - _onGroundSince > MaxTimeOnGround
            ? new MissionStep(MissionEvent.Impossible, "the vehicle is on the ground without a command to land")
            : MissionStep.Stay;
    }

    private MissionStep CheckFence(MissionFlight flight)
    {
        double outside = -flight.Plan!.Fence.SignedDistance(flight.Position);
        _outsideSince = outside > 0 ? _outsideSince ?? flight.Now : null;
        return flight.Now - _outsideSince >= MaxTimeOutside
            ? new MissionStep(MissionEvent.ReturnToLaunch, $"{MissionNumbers.Of(outside)} m outside the fence")
            : MissionStep.Stay;
    }
}
