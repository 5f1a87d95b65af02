using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The stop of the program in flight: while we command the vehicle it holds or returns first, verified by the answer of
/// the autopilot. A take-off that has not left the ground is prevented: the motors are stopped. In our own return or
/// landing, after a takeover and on the ground nothing is sent.
/// </summary>
internal sealed class MissionStop
{
    private const string Why = "the program stops";

    private static readonly TimeSpan MaxDelay = TimeSpan.FromSeconds(3);

    private TimeSpan? _since;
    private bool _isInTheAir;

    public MissionStopResult Result { get; private set; }

    /// <summary>Whether a stop is to wait for us.</summary>
    public bool Delays { get; private set; }

    /// <summary>Whether it keeps a vehicle on the ground whose take-off was commanded.</summary>
    public bool PreventsTakeOff { get; private set; }

    /// <summary>What is to be done because of the stop; in each tick, before the phase.</summary>
    public MissionStep Check(MissionFlight flight, MissionPhase phase)
    {
        if (!flight.IsStopRequested || _since is not null || !IsOurFlight(phase))
            return MissionStep.Stay;
        PreventsTakeOff = IsBeforeLiftOff(flight, phase);
        if (!flight.IsFlying && !PreventsTakeOff)
            return MissionStep.Stay;
        _since = flight.Now;
        Result = MissionStopResult.InProgress;
        return PreventsTakeOff ? MissionStep.Stay : ToHoldOrReturn(flight, phase);
    }

    /// <summary>In each tick while it prevents the take-off, instead of the phase.</summary>
    public MissionStep KeepOnGround(MissionFlight flight, MissionPhase phase)
    {
        if (flight.IsFlying)
        {
            // It had left the ground before its report said so.
            PreventsTakeOff = false;
            return ToHoldOrReturn(flight, phase);
        }

        flight.SetGoal(VehicleCommandKind.Disarm, "disarm");
        flight.Text = "disarming: " + Why;
        return MissionStep.Stay;
    }

    /// <summary>What became of it; at the end of each tick.</summary>
    public void Update(MissionFlight flight, MissionPhase phase)
    {
        if (_since is { } since && Result == MissionStopResult.InProgress)
            Result = ResultOf(flight, phase, flight.Now - since);
        _isInTheAir = flight.IsFlying;
        Delays = _since is null
            ? (IsOurFlight(phase) && _isInTheAir) || IsBeforeLiftOff(flight, phase)
            : Result == MissionStopResult.InProgress;
    }

    /// <summary>The program ends now, whether or not it waited for us.</summary>
    public void End(MissionPhase phase)
    {
        bool isLeftAlone = Result == MissionStopResult.None && IsOurFlight(phase) && _isInTheAir;
        if (Result == MissionStopResult.InProgress || isLeftAlone)
            Result = MissionStopResult.NotVerified;
    }

    private static bool IsOurFlight(MissionPhase phase)
        => phase is MissionPhase.TakingOff or MissionPhase.InTransit or MissionPhase.Searching
            or MissionPhase.Revisiting or MissionPhase.Holding;

    private static bool IsBeforeLiftOff(MissionFlight flight, MissionPhase phase)
        => phase == MissionPhase.TakingOff && flight.Vehicle.IsArmed && !flight.IsFlying;

    private static MissionStep ToHoldOrReturn(MissionFlight flight, MissionPhase phase)
        => flight.Options.OnStop == OnStop.Return
            ? new MissionStep(MissionEvent.ReturnToLaunch, Why)
            : new MissionStep(phase == MissionPhase.Holding ? MissionEvent.None : MissionEvent.Hold, Why);

    private MissionStopResult ResultOf(MissionFlight flight, MissionPhase phase, TimeSpan waited)
    {
        VehicleCommandKind kind = flight.Commands.GoalKind;
        bool isAccepted = flight.Commands.IsAccepted;
        if (phase is MissionPhase.HandedOver or MissionPhase.Done or MissionPhase.Failed or MissionPhase.Landing)
            return MissionStopResult.None;
        if (PreventsTakeOff && !flight.Vehicle.IsArmed)
            return MissionStopResult.None;
        if (isAccepted && phase == MissionPhase.Holding && kind == VehicleCommandKind.Hold)
            return MissionStopResult.Held;
        if (isAccepted && phase == MissionPhase.Returning && kind == VehicleCommandKind.Return)
            return MissionStopResult.Returning;
        return waited >= MaxDelay ? MissionStopResult.NotVerified : MissionStopResult.InProgress;
    }
}
