using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Goes from phase to phase: the guards first, then the phase itself, then <see cref="MissionTransitions"/>.</summary>
internal sealed class MissionMachine
{
    private readonly MissionFlight _flight;
    private readonly MissionFailsafes _guards = new();
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
            new WaitingForVehicleState(), new ArmingState(), new TakingOffState(), new InTransitState(), new SearchingState(), new RevisitingState(),
            new ReturningState(), new LandingState(),
            new EndState(MissionPhase.Done), new EndState(MissionPhase.HandedOver), new EndState(MissionPhase.Failed),
        }.ToDictionary(s => s.Phase);
        _state = _states[MissionPhase.WaitingForVehicle];
    }

    public MissionPhase Phase => _state.Phase;

    /// <summary>When the phase began.</summary>
    public TimeSpan Since { get; private set; }

    /// <summary>Whether nothing more will happen.</summary>
    public bool IsOver => _state is EndState;

    /// <summary>Looks at things, goes on, and sends what is to be sent.</summary>
    /// <param name="abort">Why the mission is to be given up; null where it is not.</param>
    public void Tick(string? abort)
    {
        if (IsOver)
            return;
        MissionStep step = MissionFailsafes.Authority(_flight);
        bool canAct = false;
        if (step.What == MissionEvent.None)
            step = _guards.Contact(_flight, out canAct);
        bool mayAct = canAct || Phase == MissionPhase.WaitingForVehicle || (Phase == MissionPhase.Landing && _flight.IsHeard);
        if (mayAct && !ChangesPhase(step))
            step = Act(abort, canAct);
        _couldAct = canAct;
        _lastTick = _flight.Now;
        if (step.What != MissionEvent.None)
            Go(step);
        if (_flight.IsHeard && !IsOver)
            _flight.Desk.Send(_flight.Now);
    }

    private MissionStep Act(string? abort, bool canAct)
    {
        // Time in which nobody was heard does not count; what was said then may not have been heard either.
        if (canAct && !_couldAct && Phase != MissionPhase.WaitingForVehicle)
        {
            _flight.Log("the vehicle is heard again");
            _flight.Desk.SendAgain();
        }
        else
        {
            _flight.ActiveTime += _flight.Now - _lastTick;
        }

        MissionStep step = _guards.Watch(_flight, Phase, abort);
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

    // Motors that we let run on the ground are stopped; in the air nothing is known that would be safer than what the autopilot does.
    private void MakeSafe(MissionPhase from)
    {
        if (from == MissionPhase.WaitingForVehicle || !_flight.Vehicle.IsArmed || _flight.IsFlying || !_flight.IsHeard)
            return;
        _flight.Want(VehicleCommandKind.Disarm, "disarm");
        _flight.Desk.Send(_flight.Now);
    }
}
