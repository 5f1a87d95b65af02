using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The state machine of a mission: the failsafes first, then the phase itself, then <see cref="MissionTransitions"/>.
/// </summary>
internal sealed class MissionMachine
{
    private readonly MissionFlight _flight;
    private readonly MissionFailsafes _failsafes = new();
    private readonly LegProgress _progress = new();
    private readonly Dictionary<MissionPhase, MissionState> _states;
    private MissionState _state;
    private TimeSpan _lastTick;
    private TimeSpan _activeSince;
    private bool _couldAct = true;
    private bool _givesWay;

    public MissionMachine(MissionFlight flight)
    {
        _flight = flight;
        _states = new MissionState[]
        {
            new WaitingForVehicleState(), new ArmingState(), new TakingOffState(), new InTransitState(),
            new SearchingState(), new RevisitingState(), new HoldingState(), new ReturningState(), new LandingState(),
            new HandedOverState(), new EndState(MissionPhase.Done), new EndState(MissionPhase.Failed),
        }.ToDictionary(s => s.Phase);
        _state = _states[MissionPhase.WaitingForVehicle];
    }

    public MissionPhase Phase => _state.Phase;

    /// <summary>When the phase began.</summary>
    public TimeSpan Since { get; private set; }

    /// <summary>Whether nothing more will happen.</summary>
    public bool IsOver => _state.IsOver;

    /// <summary>The stop of the program.</summary>
    public MissionStop Stop { get; } = new();

    /// <summary>One step: failsafes, the phase, the transition, and the command that is due.</summary>
    public void Tick()
    {
        bool isOurs = Phase != MissionPhase.HandedOver;
        _flight.Operator.Update(_flight.Now, keepsReturn: isOurs);
        _flight.OperatorActions.Update(_flight, Phase, IsOver);
        if (IsOver)
            return;

        MissionStep step = isOurs ? Step() : _state.Tick(_flight, _flight.Now - Since);
        if (!isOurs)
            ExplainTakeover();
        _lastTick = _flight.Now;
        bool hasChanged = Go(step);
        Stop.Update(_flight, Phase);
        if (IsOver || hasChanged)
            return;

        // In the tick of a change the goal is still that of the phase before.
        if (_flight.IsConnected)
        {
            _flight.Commands.Send(_flight.Now);
            _flight.Camera.Send();
        }

        _flight.Commands.Renew(_flight.Now);
    }

    private MissionStep Step()
    {
        MissionStep step = MissionFailsafes.CheckAuthority(_flight);
        bool canAct = false;
        if (step.What == MissionEvent.None)
            step = _failsafes.CheckConnection(_flight, out canAct);
        if (step.What == MissionEvent.None)
            step = Stop.Check(_flight, Phase);
        if (step.What == MissionEvent.None && Stop.PreventsTakeOff)
            return Stop.KeepOnGround(_flight, Phase);
        bool mayAct = canAct || Phase == MissionPhase.WaitingForVehicle
            || (Phase == MissionPhase.Landing && _flight.IsConnected);
        if (mayAct && !ChangesPhase(step))
            step = Act(canAct);
        _couldAct = canAct;
        return step;
    }

    private MissionStep Act(bool canAct)
    {
        // Time without a connection does not count; a command sent in it may have been lost.
        if (canAct && !_couldAct && Phase != MissionPhase.WaitingForVehicle)
        {
            _flight.Log("the autopilot is connected again");

            // A vehicle that has taken off refuses to do so again.
            // A fixed wing is commanded once for each leg, and flies on to its place.
            // One that has landed meanwhile is not sent home once more.
            bool isUnderway = Phase == MissionPhase.TakingOff && _flight.IsFlying && _flight.Commands.IsAccepted;
            bool isDown = Phase is MissionPhase.Returning or MissionPhase.Landing && !_flight.Vehicle.IsArmed;
            if (!isUnderway && !isDown && !_flight.IsFixedWing)
                _flight.Commands.Resend();
        }
        else if (!_givesWay)
        {
            _flight.ActiveTime += _flight.Now - _lastTick;
        }

        MissionStep step = _failsafes.Check(_flight, Phase);
        if (ChangesPhase(step))
            return step;
        if (OperatorRules.IsCommand(step.What))
            _flight.Operator.Refuse($"nothing changes in phase {Phase}");
        _givesWay = false;
        if (IsOnLeg && _flight.Group is { } group && group.KeepClear(_flight, out string? blockedBy))
        {
            _givesWay = true;
            return blockedBy is null ? MissionStep.Stay : _state.LeaveLeg(_flight, blockedBy);
        }

        step = _state.Tick(_flight, _flight.ActiveTime - _activeSince);
        return step.What == MissionEvent.None && IsOnLeg ? _progress.Check(_flight) : step;
    }

    private bool IsOnLeg
        => Phase is MissionPhase.InTransit or MissionPhase.Searching or MissionPhase.Revisiting
            && !_flight.IsFixedWing;

    // The operator's hold takes the place of our own; the way to another lane begins again.
    private bool ChangesPhase(MissionStep step)
        => MissionTransitions.After(Phase, step.What) != Phase
            || (Phase == MissionPhase.Holding && step.What == MissionEvent.OperatorHold)
            || (Phase == MissionPhase.InTransit && step.What == MissionEvent.OperatorSkip);

    private bool Go(MissionStep step)
    {
        if (!ChangesPhase(step))
            return false;
        MissionPhase from = Phase;
        MissionPhase to = MissionTransitions.After(from, step.What);
        Note(step);
        if (step.What == MissionEvent.Impossible)
            MakeSafe(from);
        _flight.Text = step.Reason;
        _flight.Log($"{from} -> {to}: {step.Reason}");
        _state.Leave(_flight);
        _flight.Group?.EndGiveWay();
        if (from == MissionPhase.HandedOver)
            _failsafes.Reset();
        _state = _states[to];
        Since = _flight.Now;
        _activeSince = _flight.ActiveTime;
        _state.Enter(_flight, step.What, step.Reason);
        return true;
    }

    // What took the command away may turn out later: a failsafe's text, a reboot.
    private void ExplainTakeover()
    {
        if (!_flight.IsTakenOver || _flight.Authority.State != CommandAuthorityState.TakenAway)
            return;
        string takeover = MissionFailsafes.Takeover(_flight.Authority);
        if (takeover == _flight.TakenOver)
            return;
        _flight.Log(takeover);
        _flight.TakenOver = _flight.Text = takeover;
    }

    private void Note(in MissionStep step)
    {
        switch (step.What)
        {
            case MissionEvent.ReturnToLaunch or MissionEvent.LandNow or MissionEvent.AlreadyFlying:
                _flight.Aborted ??= step.Reason;
                break;
            case MissionEvent.Hold when _flight.IsStopRequested:
                _flight.Aborted ??= step.Reason;
                break;
            case var what when OperatorRules.IsCommand(what):
                _flight.Ordered = _flight.Operator.Accept();
                _flight.Aborted = what switch
                {
                    MissionEvent.OperatorReturn or MissionEvent.OperatorLand => _flight.Aborted ?? step.Reason,
                    MissionEvent.OperatorContinue or MissionEvent.OperatorRevisit => null,
                    _ => _flight.Aborted,
                };
                _flight.IsTakenOver &= what is not (MissionEvent.OperatorContinue or MissionEvent.OperatorRevisit);
                break;
            case MissionEvent.TakenOver:
                _flight.TakenOver = step.Reason;
                _flight.IsTakenOver = true;
                break;
            default:
                break;
        }
    }

    // Motors that we started are stopped on the ground; in the air nothing is safer than what the autopilot does by
    // itself.
    private void MakeSafe(MissionPhase from)
    {
        bool isOurs = from != MissionPhase.WaitingForVehicle && _flight.Vehicle.IsArmed && !_flight.IsFlying
            && !_flight.IsFixedWing;
        if (!isOurs || !_flight.IsConnected)
            return;
        _flight.SetGoal(VehicleCommandKind.Disarm, "disarm");
        _flight.Commands.Send(_flight.Now);
    }
}
