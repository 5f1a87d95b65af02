using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// PX4 without its messages: the mode that was chosen and the one that is flown, arming, the detection of the ground.
/// The chosen mode is flown where it can be and no failsafe wants another one; OFFBOARD therefore comes back by itself
/// with its set-points, as long as no other mode has been chosen.
/// </summary>
internal sealed partial class Px4Controller
{
    private const double GroundSeconds = 3.1;   // of contact until "landing detected", as recorded

    private const double BackInsideSpeed = 1;   // m/s in the hold of the fence; recorded: 1 to 3

    private readonly Px4Events _events;
    private readonly Px4Failsafes _failsafes;
    private readonly Px4ManualFlight _position = new(holdsPosition: true);
    private readonly Px4ManualFlight _altitude = new(holdsPosition: false);
    private readonly Px4LandFlight _land = new();
    private readonly Px4ReturnFlight _return;
    private readonly Px4PositionCheck _positionCheck;
    private Px4Flight _flight;
    private Px4Mode _afterDisarming = Px4Mode.Loiter;
    private Px4Action _fallback;
    private double _contactSeconds;
    private TimeSpan _landedAt;
    private bool _hasFlown;

    public Px4Controller(Px4Situation situation, Px4Checks checks, Px4Events events, WorldFrame frame)
    {
        Situation = situation;
        Checks = checks;
        _events = events;
        _failsafes = new Px4Failsafes(situation, events);
        _positionCheck = new Px4PositionCheck(events);
        _return = new Px4ReturnFlight(events, frame);
        _flight = Hold;
    }

    public Px4Situation Situation { get; }

    public Px4Checks Checks { get; }

    public Px4HoldFlight Hold { get; } = new();

    public Px4OffboardFlight Offboard { get; } = new();

    public Px4OrbitFlight Orbit { get; } = new();

    public Px4TakeoffFlight Takeoff { get; } = new();

    public Px4MissionFlight Mission { get; } = new();

    /// <summary>What is flown, and reported.</summary>
    public Px4Mode Mode { get; private set; } = Px4Mode.Loiter;

    /// <summary>What the pilot, the companion or the autopilot itself has chosen.</summary>
    public Px4Mode Intention { get; private set; } = Px4Mode.Loiter;

    public bool IsArmed { get; private set; }

    /// <summary>Where it flies to by itself; null where it does not.</summary>
    public NedVector? Target => IsArmed && Px4ModeNames.IsAuto(Mode) ? _flight.Target : null;

    /// <summary>Where the position controller steers to; null where it steers by velocity or not at all.</summary>
    public NedVector? LocalTarget
        => !IsArmed || Situation.IsLanded ? null : Mode == Px4Mode.Offboard ? Offboard.Target : Target;

    /// <summary>That of the last step.</summary>
    public MotionCommand Command { get; private set; }

    public MavState Status
        => !IsArmed ? MavState.Standby
            : _failsafes.Action != Px4Action.None || _fallback != Px4Action.None ? MavState.Critical : MavState.Active;

    public MavLandedState LandedState
    {
        get
        {
            if (Situation.IsLanded)
                return MavLandedState.OnGround;
            if (_flight.IsLanding)
                return MavLandedState.Landing;
            return _flight.IsTakingOff ? MavLandedState.Takeoff : MavLandedState.InAir;
        }
    }

    /// <summary>A mode is chosen; false where it cannot be flown now.</summary>
    public bool TrySetMode(Px4Mode mode)
    {
        if (IsArmed && !CanBeChosen(mode))
            return false;
        Choose(mode);
        _failsafes.ChangeMode();
        SelectMode();
        return true;
    }

    public bool TryArm(bool isForced)
    {
        if (IsArmed)
            return true;
        if (!isForced && (Checks.PreventsArming || Px4ModeNames.PreventsArming(Intention) || !CanRun(Intention)
            || IsMissionMissing(Intention)))
        {
            return false;
        }

        IsArmed = true;
        _hasFlown = false;
        _landedAt = Situation.ArmedAt = Situation.Time;
        if (Situation.HasPosition)
            Situation.Home = Situation.Position;
        _failsafes.Reset();
        _flight.Enter(Situation);
        _events.Send(
            Px4Event.ArmedBy, 0x66, default(Px4EventArguments).Byte(4), "Armed by external command");
        return true;
    }

    public bool TryDisarm(bool isForced)
    {
        if (!IsArmed)
            return true;
        if (!Situation.IsLanded && !isForced)
        {
            _events.Send(Px4Event.DisarmDeniedInAir, 0x62);
            return false;
        }

        Disarm(reason: 4, "Disarmed by external command");
        return true;
    }

    /// <summary>It has started again in the air and is armed as before, in AUTO.LOITER.</summary>
    public void StayArmed(Px4Controller before)
    {
        IsArmed = _hasFlown = true;
        Situation.IsLanded = false;
        Situation.ArmedAt = before.Situation.Time;
        Situation.Home = before.Situation.Home;
    }

    /// <summary>Makes an item of the mission the current one; flown at once where a mission is flown.</summary>
    public void JumpTo(int sequence) => Mission.JumpTo(Situation, sequence, IsArmed && _flight == Mission);

    /// <summary>Parameters were changed.</summary>
    public void ChangeParameters() => _failsafes.ResetDelay();

    /// <summary>Takes in what the sensors say, and gives the command for the next step.</summary>
    public MotionCommand Step(in VehicleSenses senses)
    {
        Feel(senses);
        bool isChecked = Checks.Step(IsArmed, senses.BatteryRemaining);
        if (!IsArmed)
        {
            Situation.IsLanded |= Situation.TouchesGround;
            return new MotionCommand { Motors = MotorState.Off, Yaw = double.NaN };
        }

        if (isChecked)
            _failsafes.Check(Intention, Checks);
        OverrideBySticks();
        _failsafes.Step(Intention);
        SelectMode();
        MotionCommand command = Fly();
        if (_flight == Takeoff && Takeoff.IsDone)
        {
            Choose(Px4Mode.Loiter);
            SelectMode();
        }
        else if (_flight == Mission && Mission.WantsReturn)
        {
            Choose(Px4Mode.Rtl);
            SelectMode();
        }

        Command = command;
        return command;
    }

    private MotionCommand Fly()
    {
        Px4Parameters parameters = Situation.Parameters;
        var command = new MotionCommand
        {
            Motors = MotorState.Flying,
            HorizontalAcceleration = parameters.Acceleration.Value,
            VerticalAcceleration = 3,   // MPC_ACC_DOWN_MAX, MPC_ACC_UP_MAX
            Yaw = double.NaN,
        };
        bool wasLanded = Situation.IsLanded;
        _flight.Fly(Situation, ref command);
        if (wasLanded && !Situation.IsLanded)
        {
            _hasFlown = true;
            _contactSeconds = 0;
            _events.Send(Px4Event.TakeoffDetected, 0x66, text: "Takeoff detected");
        }

        CheckGroundContact(command);
        DisarmWhereDone();
        return command;
    }

    private void Feel(in VehicleSenses senses)
    {
        Situation.Time = senses.Time;
        Situation.Position = senses.Position;
        Situation.Velocity = senses.Velocity;
        Situation.Yaw = senses.Yaw;
        Situation.TouchesGround = senses.TouchesGround;
        bool hasGps = senses.HasGps && Situation.Parameters.Satellites.Whole >= Px4PositionCheck.MinSatellites;
        Situation.HasPosition = _positionCheck.Step(hasGps, senses.Time);
        if (Situation.HasPosition && Situation.Home is null)
            Situation.Home = senses.Position;
    }

    private void CheckGroundContact(in MotionCommand command)
    {
        if (Situation.IsLanded)
            return;
        bool rests = Situation.TouchesGround && _hasFlown && !(command.Velocity.Down < 0) && !_flight.IsTakingOff;
        _contactSeconds = rests ? _contactSeconds + Situation.StepSeconds : 0;
        if (_contactSeconds < GroundSeconds)
            return;
        Situation.IsLanded = true;
        _landedAt = Situation.Time;
        _events.Send(Px4Event.LandingDetected, 0x66, text: "Landing detected");
    }

    private void DisarmWhereDone()
    {
        if (!Situation.IsLanded)
            return;
        double delay = _hasFlown
            ? Situation.Parameters.DisarmLanded.Value
            : Situation.Parameters.DisarmPreflight.Value;
        if (delay <= 0 || (Situation.Time - _landedAt).ExactSeconds < delay || _flight.IsTakingOff)
            return;
        if (_hasFlown)
            Disarm(reason: 6, "Disarmed by landing");
        else
            Disarm(reason: 7, "Disarmed by auto preflight disarming");
    }

    private void Disarm(int reason, string text)
    {
        IsArmed = false;
        _contactSeconds = 0;
        Intention = _afterDisarming;
        _failsafes.Reset();
        SelectMode();
        _events.Send(Px4Event.DisarmedBy, 0x66, default(Px4EventArguments).Byte(reason), text);
    }
}
