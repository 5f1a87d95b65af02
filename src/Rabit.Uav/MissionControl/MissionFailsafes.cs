using System;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>The failsafes: checked in every phase before the phase itself, the most severe first.</summary>
internal sealed class MissionFailsafes
{
    private static readonly TimeSpan MaxTimeOnGround = TimeSpan.FromSeconds(3);

    // Health Monitoring advises to return after seconds; this holds also without its advice.
    private static readonly TimeSpan MaxDisconnection = TimeSpan.FromMinutes(2);
    private static readonly TimeSpan MaxDisconnectionOnGround = TimeSpan.FromMinutes(5);
    private static readonly TimeSpan MaxTimeWithoutPosition = TimeSpan.FromSeconds(15);

    private readonly MissionLimits _limits = new();
    private TimeSpan? _disconnectedSince;
    private TimeSpan? _noPositionSince;
    private TimeSpan? _onGroundSince;
    private TimeSpan _lostFor;
    private bool _wasFlying;

    /// <summary>Command authority: checked even while no autopilot is connected.</summary>
    public static MissionStep CheckAuthority(MissionFlight flight)
    {
        if (flight.Authority.State == CommandAuthorityState.TakenAway)
            return new MissionStep(MissionEvent.TakenOver, Takeover(flight.Authority));
        if (flight.Commands.NotInCommand is not { } why)
            return MissionStep.Stay;
        return flight.Authority.State == CommandAuthorityState.Observing
            ? new MissionStep(MissionEvent.Impossible, "we only observe: " + why)
            : new MissionStep(MissionEvent.TakenOver, "the command was taken away: " + why);
    }

    /// <summary>Forgets what was observed: the command was taken away in between.</summary>
    public void Reset()
    {
        (_disconnectedSince, _noPositionSince, _onGroundSince, _lostFor) = (null, null, null, TimeSpan.Zero);
        _limits.Reset();
    }

    /// <summary>Whether the vehicle can be commanded: an autopilot is connected and has a position.</summary>
    /// <param name="flight">The state of the mission.</param>
    /// <param name="canAct">Whether the vehicle can be commanded.</param>
    public MissionStep CheckConnection(MissionFlight flight, out bool canAct)
    {
        // On the ground, and before the first connection, nothing is lost.
        if (flight.IsConnected && _disconnectedSince is { } lostSince && _wasFlying)
            _lostFor = flight.Now - lostSince;
        if (flight.IsConnected)
            _wasFlying = flight.IsFlying;
        _disconnectedSince = flight.IsConnected ? null : _disconnectedSince ?? flight.Now;
        _noPositionSince = flight.IsConnected && !flight.HasFreshPosition ? _noPositionSince ?? flight.Now : null;
        canAct = flight.IsConnected && flight.HasFreshPosition;
        if (_disconnectedSince is { } since)
        {
            flight.Text = flight.IsReported ? "autopilot not connected" : "Autopilot Interface reports nothing";

            // In the air the mission waits for the link, however long: after Failed nothing would bring it home. What
            // the first messages say before it is connected again, of a landing meanwhile, ends nothing.
            if (flight.Plan is not null && !_wasFlying && flight.Now - since > MaxDisconnectionOnGround)
                return new MissionStep(
                    MissionEvent.Impossible, $"no autopilot for {MissionNumbers.Seconds(MaxDisconnectionOnGround)}");
        }
        else if (_noPositionSince is { } lost)
        {
            flight.Text = "no position";
            if (flight.Now - lost > MaxTimeWithoutPosition && flight.IsFlying)
                return flight.LandNow($"no position for {MissionNumbers.Seconds(MaxTimeWithoutPosition)}");
        }

        return MissionStep.Stay;
    }

    /// <summary>What ends a phase from outside; only while the vehicle can be commanded.</summary>
    public MissionStep Check(MissionFlight flight, MissionPhase phase)
    {
        if (IsBeforeTakeOff(flight, phase))
            return CheckBeforeTakeOff(flight, phase);
        MissionStep motors = CheckMotors(flight, phase);
        if (motors.What != MissionEvent.None)
            return motors;
        if (flight.Health.Advice == HealthAdvice.Land)
            return flight.LandNow(Advice(flight));
        MissionStep step = CheckReturn(flight);
        if (step.What == MissionEvent.None && flight.Health.Advice == HealthAdvice.Hold)
            step = new MissionStep(MissionEvent.HealthHold, Advice(flight));
        if (flight.Operator.Pending is not { } request)
            return step;

        // A hold or a continue against a reason to return would last for one tick, and a continue against one to hold.
        bool agrees = step.What == MissionEvent.None
            || request.Command is OperatorCommand.Return or OperatorCommand.Land
            || (step.What == MissionEvent.HealthHold && request.Command == OperatorCommand.Hold);
        if (agrees)
            return OperatorRules.ToStep(request);
        flight.Operator.Refuse(step.Reason);
        return step;
    }

    /// <summary>Who took the command away, and how, as text.</summary>
    public static string Takeover(in CommandAuthority authority)
    {
        string by = authority.Cause switch
        {
            TakeoverCause.Failsafe => "the autopilot's failsafe took over",
            TakeoverCause.OtherCommander => "another commander took over",
            TakeoverCause.Reboot => "the autopilot rebooted",
            _ => "the pilot took over",
        };
        return authority.TakenBy is { } how ? $"{by}: {how}" : by;
    }

    private static string Advice(MissionFlight flight)
        => "health: " + (flight.Health.AdviceText ?? flight.Health.Text ?? "no reason given");

    private static bool IsBeforeTakeOff(MissionFlight flight, MissionPhase phase)
        => phase is MissionPhase.WaitingForVehicle or MissionPhase.Arming
            || (phase == MissionPhase.TakingOff && !flight.IsFlying);

    private static MissionStep CheckBeforeTakeOff(MissionFlight flight, MissionPhase phase)
    {
        if (phase == MissionPhase.WaitingForVehicle && flight.IsFlying)
            return MissionStep.Stay;
        if (flight.Operator.Pending
            is { Command: OperatorCommand.Hold or OperatorCommand.Return or OperatorCommand.Land } request)
        {
            flight.Operator.Accept("given up before take-off");
            flight.IsCalledOff = true;
            return new MissionStep(MissionEvent.Impossible, "given up before take-off: " + request.Reason);
        }

        flight.Operator.Refuse("it has not taken off");
        if (phase == MissionPhase.WaitingForVehicle)
            return MissionStep.Stay;
        if (MissionGuards.FindCritical(flight) is { } critical)
            return new MissionStep(MissionEvent.Impossible, "given up before take-off: " + critical);
        return flight.Health.Advice != HealthAdvice.None
            ? new MissionStep(MissionEvent.Impossible, "given up before take-off: " + Advice(flight))
            : MissionStep.Stay;
    }

    private MissionStep CheckReturn(MissionFlight flight)
    {
        TimeSpan lostFor = _lostFor;
        _lostFor = TimeSpan.Zero;
        string? reason = flight.Health.Advice == HealthAdvice.ReturnToLaunch ? Advice(flight)
            : lostFor > MaxDisconnection ? $"the link was lost for {MissionNumbers.Seconds(lostFor)}"
            : MissionGuards.Find(flight) ?? _limits.Find(flight);
        return reason is null ? MissionStep.Stay : new MissionStep(MissionEvent.ReturnToLaunch, reason);
    }

    private MissionStep CheckMotors(MissionFlight flight, MissionPhase phase)
    {
        bool isLanding = phase is MissionPhase.Returning or MissionPhase.Landing;
        bool hasLanded = isLanding && flight.Touchdown.Stop is MotorStop.Undecided or MotorStop.Landed;
        if (!flight.Vehicle.IsArmed && !hasLanded)
            return new MissionStep(MissionEvent.Impossible, flight.Touchdown.Text);

        bool isOnGround = flight.Vehicle.LandedState == MavLandedState.OnGround && !isLanding;
        _onGroundSince = isOnGround ? _onGroundSince ?? flight.Now : null;
        return flight.Now - _onGroundSince > MaxTimeOnGround
            ? new MissionStep(MissionEvent.Impossible, "the vehicle is on the ground without a command to land")
            : MissionStep.Stay;
    }
}
