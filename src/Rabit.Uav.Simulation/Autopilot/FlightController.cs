using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The autopilot without its messages: modes, arming with its checks, take-off, the detection of the ground,
/// fail-safes. It refuses what ArduCopter refuses, with its words.
/// </summary>
internal sealed class FlightController
{
    private const double GroundSeconds = 2;   // of contact, until it counts as landed
    private static readonly TimeSpan PreArmCheckPeriod = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan PreArmEvery = TimeSpan.FromSeconds(30);

    private readonly Action<MavSeverity, string> _say;
    private readonly HoldFlight _hold = new();
    private readonly LandFlight _land = new();
    private readonly ReturnFlight _return = new();
    private FlightMode _flight;
    private double _contactSeconds;
    private TimeSpan _idleSince;
    private TimeSpan _nextPreArm = PreArmCheckPeriod;

    /// <param name="parameters">Read as it flies.</param>
    /// <param name="say">Takes the status texts.</param>
    public FlightController(ParameterStore parameters, Action<MavSeverity, string> say)
    {
        _say = say;
        Situation = new FlightSituation(parameters);
        Failsafes = new Failsafes(parameters, this, say);
        _flight = _hold;
    }

    public FlightSituation Situation { get; }

    public Failsafes Failsafes { get; }

    public GuidedFlight Guided { get; } = new();

    public CopterMode Mode { get; private set; }

    public bool IsArmed { get; private set; }

    public bool HasPosition { get; set; }

    public bool IsGuided => Mode == CopterMode.Guided;

    public double BatteryVolts { get; set; }

    /// <summary>Called when it has armed: home is where it is, and HOME_POSITION is sent.</summary>
    public Action? Armed { get; set; }

    public MavState Status
        => IsArmed && Failsafes.IsAnyOn ? MavState.Critical : Situation.IsLanded ? MavState.Standby : MavState.Active;

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

    /// <summary>Changes the mode, as a ground station or a fail-safe wants it; says why it cannot.</summary>
    public bool TrySetMode(uint number)
    {
        if (!CopterModes.IsKnown(number))
        {
            _say(MavSeverity.Warning, FormattableString.Invariant($"No such mode {number}"));
            return false;
        }

        var mode = (CopterMode)number;
        if (mode == Mode)
            return true;

        // On the ground any mode may be taken; arming checks again.
        string? refusal = !IsArmed ? null
            : mode == CopterMode.Auto ? "init failed"
            : CopterModes.NeedsPosition(mode) && !HasPosition ? "requires position" : null;
        if (refusal is not null)
        {
            _say(MavSeverity.Warning, $"Mode change to {CopterModes.NameOf(mode)} failed: {refusal}");
            return false;
        }

        Enter(mode);
        return true;
    }

    public bool TryArm(bool isForced)
    {
        if (IsArmed)
            return true;
        string? refusal = FindReasonNotToArm(isForced, checksMode: true);
        if (refusal is not null)
        {
            _say(MavSeverity.Critical, "Arm: " + refusal);
            return false;
        }

        IsArmed = true;
        _idleSince = Situation.Time;
        Failsafes.Reset();
        _flight.Enter(Situation);
        Armed?.Invoke();
        _say(MavSeverity.Info, "Arming motors");
        return true;
    }

    public bool TryDisarm(bool isForced)
    {
        if (!IsArmed)
            return true;
        if (!Situation.IsLanded && !isForced)
            return false;
        Disarm();
        return true;
    }

    /// <summary>Only from the ground, armed, in GUIDED, to above where it is.</summary>
    public bool TryTakeOff(double heightMetres)
    {
        if (!IsArmed || !IsGuided || !Situation.IsLanded || !(heightMetres > Situation.Height))
            return false;
        Guided.TakeOff(Situation, heightMetres);
        return true;
    }

    /// <summary>The command for the next step.</summary>
    public MotionCommand Step()
    {
        FlightSituation situation = Situation;
        Failsafes.Step();
        if (!IsArmed)
        {
            SayPreArm();
            if (situation.TouchesGround)
                situation.IsLanded = true;
            return new MotionCommand { Motors = MotorState.Off, Yaw = double.NaN };
        }

        var command = new MotionCommand
        {
            Motors = MotorState.Flying,
            HorizontalAcceleration = situation.HorizontalAcceleration,
            VerticalAcceleration = situation.VerticalAcceleration,
            Yaw = double.NaN,
        };
        _flight.Fly(situation, ref command);
        CheckGroundContact(command);
        DisarmWhereDone();
        return command;
    }

    private void Enter(CopterMode mode)
    {
        Mode = mode;
        _flight = mode switch
        {
            CopterMode.Guided => Guided,
            CopterMode.Rtl => _return,
            CopterMode.Land => _land,
            _ => _hold,
        };
        _flight.Enter(Situation);
    }

    private void CheckGroundContact(in MotionCommand command)
    {
        FlightSituation situation = Situation;
        if (command.Motors == MotorState.Flying && command.Velocity.Down < 0)
        {
            situation.IsLanded = false;
            _contactSeconds = 0;
        }
        else if (!situation.IsLanded)
        {
            _contactSeconds = situation.TouchesGround ? _contactSeconds + situation.StepSeconds : 0;
            situation.IsLanded = _contactSeconds >= GroundSeconds;
        }
    }

    private void DisarmWhereDone()
    {
        if (!Situation.IsLanded)
        {
            _idleSince = Situation.Time;
            return;
        }

        // Landed by itself, or forgotten on the ground.
        double delay = Situation.Parameters.DisarmDelay.Value;
        bool isForgotten = delay > 0 && !_flight.IsTakingOff && (Situation.Time - _idleSince).TotalSeconds >= delay;
        if (_flight.DisarmsWhenLanded || isForgotten)
            Disarm();
    }

    private void Disarm()
    {
        IsArmed = false;
        _contactSeconds = 0;
        _say(MavSeverity.Info, "Disarming motors");
    }

    // Looked at each second; said again after half a minute.
    private void SayPreArm()
    {
        if (Situation.Time < _nextPreArm)
            return;
        string? reason = FindReasonNotToArm(isForced: false, checksMode: false);
        _nextPreArm = Situation.Time + (reason is null ? PreArmCheckPeriod : PreArmEvery);
        if (reason is not null)
            _say(MavSeverity.Critical, "PreArm: " + reason);
    }

    private string? FindReasonNotToArm(bool isForced, bool checksMode)
    {
        ParameterStore parameters = Situation.Parameters;
        if (CopterModes.NeedsPosition(Mode) && !HasPosition)
            return "Need Position Estimate";
        if (isForced)
            return null;
        if (checksMode && !CopterModes.IsArmable(Mode))
            return CopterModes.NameOf(Mode) + " mode not armable";
        if (parameters.ArmingCheck.Value.Equals(0))
            return null;
        if (BatteryVolts < parameters.BatteryArmVolts.Value)
            return "Battery 1 below minimum arming voltage";
        return BatteryVolts < parameters.BatteryLowVolts.Value ? "Battery 1 low voltage failsafe" : null;
    }
}
