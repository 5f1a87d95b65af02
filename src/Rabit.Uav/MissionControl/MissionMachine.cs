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
    private readonly Dictionary<MissionPhase, MissionState> _states;
    private MissionState _state;
    private TimeSpan _lastTick;
    private TimeSpan _activeSince;
    private bool _couldAct = true;

    public MissionMachine(MissionFlight flight)
    {
        _flight = flight;
        _states = new MissionState[]
        {
            new WaitingForVehicleState(), new ArmingState(), new TakingOffState(), new InTransitState(),
            new SearchingState(), new RevisitingState(), new ReturningState(), new LandingState(),
            new EndState(MissionPhase.Done), new EndState(MissionPhase.HandedOver), new EndState(MissionPhase.Failed),
        }.ToDictionary(s => s.Phase);
        _state = _states[MissionPhase.WaitingForVehicle];
    }

    public MissionPhase Phase => _state.Phase;

    /// <summary>When the phase began.</summary>
    public TimeSpan Since { get; private set; }

    /// <summary>Whether nothing more will happen.</summary>
    public bool IsOver => _state is EndState;

    /// <summary>One step: failsafes, the phase, the transition, and the command that is due.</summary>
    /// <param name="abort">Why the mission is to be aborted; null where it is not.</param>
    public void Tick(string? abort)
    {
        if (IsOver)
            return;
        MissionStep step = MissionFailsafes.CheckAuthority(_flight);
        bool canAct = false;
        if (step.What == MissionEvent.None)
            step = _failsafes.CheckConnection(_flight, out canAct);
        bool mayAct = canAct || Phase == MissionPhase.WaitingForVehicle
            || (Phase == MissionPhase.Landing && _flight.IsConnected);
        if (mayAct && !ChangesPhase(step))
            step = Act(abort, canAct);
        _couldAct = canAct;
        _lastTick = _flight.Now;
        if (step.What != MissionEvent.None)
            Go(step);
        if (_flight.IsConnected && !IsOver)
            _flight.Commands.Send(_flight.Now);
    }

    private MissionStep Act(string? abort, bool canAct)
    {
        // Time without a connection does not count; a command sent in it may have been lost.
        if (canAct && !_couldAct && Phase != MissionPhase.WaitingForVehicle)
        {
            _flight.Log("the autopilot is connected again");
            _flight.Commands.Resend();
        }
        else
        {
            _flight.ActiveTime += _flight.Now - _lastTick;
        }

        MissionStep step = _failsafes.Check(_flight, Phase, abort);
        return ChangesPhase(step) ? step : _state.Tick(_flight, _flight.ActiveTime - _activeSince);
    }

    private bool ChangesPhase(MissionStep step) => MissionTransitions.After(Phase, step.What) != Phase;

    private void Go(MissionStep step)
    {
        MissionPhase from = Phase;
        MissionPhase to = MissionTransitions.After(from, step.What);
        if (to == from)
            return;
        if (step.What is MissionEvent.ReturnToLaunch or MissionEvent.LandNow)
            _flight.Aborted ??= step.Reason;
        if (step.What == MissionEvent.Impossible)
            MakeSafe(from);
        _flight.Text = step.Reason;
        _flight.Log($"{from} -> {to}: {step.Reason}");
        _state = _states[to];
        Since = _flight.Now;
        _activeSince = _flight.ActiveTime;
        _state.Enter(_flight, step.What);
    }

    // Motors that we started are stopped on the ground; in the air nothing is safer than what the autopilot does by
    // itself.
    private void MakeSafe(MissionPhase from)
    {
        bool isOurs = from != MissionPhase.WaitingForVehicle && _flight.Vehicle.IsArmed && !_flight.IsFlying;
        if (!isOurs || !_flight.IsConnected)
            return;
        _flight.SetGoal(VehicleCommandKind.Disarm, "disarm");
        _flight.Commands.Send(_flight.Now);
    }
}
