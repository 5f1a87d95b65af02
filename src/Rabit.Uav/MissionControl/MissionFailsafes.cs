using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>What is watched in every phase, before the phase itself has its say; the gravest first.</summary>
internal sealed class MissionFailsafes
{
    // Below this motors that stopped have landed.
    private const double LandedHeightMetres = 5;

    // One position outside may be a bad one.
    private static readonly TimeSpan OutsideFor = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan OnGroundFor = TimeSpan.FromSeconds(3);
    private static readonly TimeSpan MaxSilence = TimeSpan.FromMinutes(5);
    private static readonly TimeSpan MaxTimeWithoutPosition = TimeSpan.FromSeconds(15);

    private TimeSpan? _silentSince;
    private TimeSpan? _lostPlaceSince;
    private TimeSpan? _outsideSince;
    private TimeSpan? _onGroundSince;

    /// <summary>Who commands: looked at even when the vehicle is not heard.</summary>
    public static MissionStep Authority(MissionFlight flight)
    {
        if (flight.Authority.State == CommandAuthorityState.TakenAway)
            return new MissionStep(MissionEvent.TakenOver, flight.Authority.TakenBy ?? "the pilot or the autopilot took over");
        if (flight.Desk.NotInCommand is not { } why)
            return MissionStep.Stay;
        return flight.Authority.State == CommandAuthorityState.Observing
            ? new MissionStep(MissionEvent.Impossible, "we only observe: " + why)
            : new MissionStep(MissionEvent.TakenOver, why);
    }

    /// <summary>Whether anything can be done at all: the vehicle is heard and knows where it is.</summary>
    /// <param name="flight">Everything there is to know.</param>
    /// <param name="canAct">Whether it can.</param>
    public MissionStep Contact(MissionFlight flight, out bool canAct)
    {
        _silentSince = flight.IsHeard ? null : _silentSince ?? flight.Now;
        _lostPlaceSince = flight.IsHeard && !flight.KnowsWhereItIs ? _lostPlaceSince ?? flight.Now : null;
        canAct = flight.IsHeard && flight.KnowsWhereItIs;
        if (_silentSince is { } silent)
        {
            flight.Text = "the autopilot is not heard";
            if (flight.Plan is not null && flight.Now - silent > MaxSilence)
                return new MissionStep(MissionEvent.Impossible, $"the autopilot was not heard for {MissionText.Seconds(MaxSilence)}");
        }
        else if (_lostPlaceSince is { } lost)
        {
            flight.Text = "the vehicle does not know where it is";
            if (flight.Now - lost > MaxTimeWithoutPosition && flight.IsFlying)
                return new MissionStep(MissionEvent.LandNow, $"no position for {MissionText.Seconds(MaxTimeWithoutPosition)}");
        }

        return MissionStep.Stay;
    }

    /// <summary>What ends a phase from outside; only while something can be done.</summary>
    public MissionStep Watch(MissionFlight flight, MissionPhase phase, string? abort)
    {
        if (IsBeforeTakeOff(flight, phase))
            return BeforeTakeOff(flight, phase, abort);
        MissionStep motors = Motors(flight, phase);
        if (motors.What != MissionEvent.None)
            return motors;
        if (flight.Health.Advice == HealthAdvice.Land)
            return new MissionStep(MissionEvent.LandNow, Advice(flight));
        if (abort is not null)
            return new MissionStep(MissionEvent.ReturnToLaunch, abort);
        if (flight.Health.Advice == HealthAdvice.ReturnToLaunch)
            return new MissionStep(MissionEvent.ReturnToLaunch, Advice(flight));
        return Fence(flight);
    }

    private static string Advice(MissionFlight flight) => "health: " + (flight.Health.AdviceText ?? flight.Health.Text ?? "no reason told");

    private static bool IsBeforeTakeOff(MissionFlight flight, MissionPhase phase)
        => phase is MissionPhase.WaitingForVehicle or MissionPhase.Arming || (phase == MissionPhase.TakingOff && !flight.IsFlying);

    private static MissionStep BeforeTakeOff(MissionFlight flight, MissionPhase phase, string? abort)
    {
        if (abort is not null)
            return new MissionStep(MissionEvent.Impossible, "given up before take-off: " + abort);
        return phase != MissionPhase.WaitingForVehicle && flight.Health.Advice != HealthAdvice.None
            ? new MissionStep(MissionEvent.Impossible, "given up before take-off: " + Advice(flight))
            : MissionStep.Stay;
    }

    private MissionStep Motors(MissionFlight flight, MissionPhase phase)
    {
        bool isLanding = phase is MissionPhase.Returning or MissionPhase.Landing;
        if (!flight.Vehicle.IsArmed && (!isLanding || flight.HeightMetres > LandedHeightMetres))
            return new MissionStep(MissionEvent.Impossible, $"the motors stopped at a height of {MissionText.Of(flight.HeightMetres)} m");
        bool isOnGround = flight.Vehicle.LandedState == MavLandedState.OnGround && !isLanding;
        _onGroundSince = isOnGround ? _onGroundSince ?? flight.Now : null;
        return flight.Now - _onGroundSince > OnGroundFor
            ? new MissionStep(MissionEvent.Impossible, "the vehicle is on the ground and was not told to land")
            : MissionStep.Stay;
    }

    private MissionStep Fence(MissionFlight flight)
    {
        double outside = -flight.Plan!.Fence.SignedDistance(flight.Position);
        _outsideSince = outside > 0 ? _outsideSince ?? flight.Now : null;
        return flight.Now - _outsideSince >= OutsideFor
            ? new MissionStep(MissionEvent.ReturnToLaunch, $"{MissionText.Of(outside)} m outside the fence")
            : MissionStep.Stay;
    }
}
