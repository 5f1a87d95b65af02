using System;
using Rabit.Geodesy;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// The autopilot without its messages: modes, arming with its checks, take-off, the detection of the ground,
/// fail-safes. It refuses what ArduCopter refuses, with its words.
/// </summary>
internal sealed class FlightController
{
    // After its first heartbeat: ap-fence-reboot in tests/data/autopilots.
    private static readonly TimeSpan InitialisationTime = TimeSpan.OfSeconds(1.4);

    private readonly Action<MavSeverity, string> _say;
    private readonly HoldFlight _hold = new();
    private readonly LandFlight _land = new();
    private readonly ReturnFlight _return = new();
    private readonly LandingDetector _landing = new();
    private readonly ArmingChecks _checks;
    private readonly TimeSpan _initialisedAt;
    private FlightMode _flight;
    private TimeSpan _idleSince;

    /// <param name="parameters">Read as it flies.</param>
    /// <param name="say">Takes the status texts.</param>
    /// <param name="startTime">When its first heartbeat is due after a reboot; null: it has been on for long.</param>
    public FlightController(ParameterStore parameters, Action<MavSeverity, string> say, TimeSpan? startTime = null)
    {
        _say = say;
        _initialisedAt = startTime is { } start ? start + InitialisationTime : TimeSpan.Zero;
        StartTime = startTime ?? TimeSpan.Zero;
        Situation = new FlightSituation(parameters);
        Failsafes = new Failsafes(parameters, this, say);
        Switch = new ModeSwitch(parameters, this);
        _checks = new ArmingChecks(this, say);
        _flight = _hold;
    }

    public FlightSituation Situation { get; }

    public Failsafes Failsafes { get; }

    public GuidedFlight Guided { get; } = new();

    public AutoFlight Auto { get; } = new();

    public CopterMode Mode { get; private set; }

    public bool IsArmed { get; private set; }

    public ModeSwitch Switch { get; }

    /// <summary>By the clock of the run; zero where it was on before.</summary>
    public TimeSpan StartTime { get; }

    /// <summary>Whether it has known where it is since its start.</summary>
    public bool HasOrigin { get; set; }

    /// <summary>Whether it knows where it is now.</summary>
    public bool HasPosition => HasOrigin && !Failsafes.Estimator.IsOn;

    /// <summary>Whether the checks before arming have passed.</summary>
    public bool IsReadyToArm => _checks.HasPassed;

    public bool IsGuided => Mode == CopterMode.Guided;

    public bool IsAuto => Mode == CopterMode.Auto && IsArmed;

    /// <summary>Where RTL flies to now; null in other modes and while it lands.</summary>
    public NedVector? ReturnTarget => Mode == CopterMode.Rtl ? _return.Target : null;

    public bool IsLanding => _flight.IsLanding;

    /// <summary>Called when it has armed: home is where it is, and HOME_POSITION is sent.</summary>
    public Action? Armed { get; set; }

    /// <summary>Called when the mode has changed: the heartbeat is sent at once.</summary>
    public Action? ModeChanged { get; set; }

    public MavState Status
        => Situation.Time < _initialisedAt ? MavState.Boot
            : Failsafes.IsAnyOn ? MavState.Critical
            : Situation.IsLanded ? MavState.Standby : MavState.Active;

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
            : mode == CopterMode.Auto && !Auto.HasMission ? "init failed"
            : CopterModes.NeedsPosition(mode) && !HasPosition ? "requires position" : null;
        if (refusal is not null)
        {
            _say(MavSeverity.Warning, $"Mode change to {CopterModes.NameOf(mode)} failed: {refusal}");
            return false;
        }

        Enter(mode);
        return true;
    }

    /// <summary>LAND, with the pause before the descent that a failsafe leaves.</summary>
    public void LandAfterPause()
    {
        if (Mode == CopterMode.Land)
            return;
        _land.PausesFirst = true;
        TrySetMode((uint)CopterMode.Land);
        _land.PausesFirst = false;
    }

    /// <summary>After a reset in flight: armed and in the air as before, in the mode of the start.</summary>
    public void StayArmed(FlightController before)
    {
        IsArmed = before.IsArmed;
        Situation.CopyFrom(before.Situation);
        _idleSince = Situation.Time;
        _flight.Enter(Situation);
    }

    public bool TryArm(bool isForced)
    {
        if (IsArmed)
            return true;
        if (!_checks.Check(isForced))
            return false;
        IsArmed = true;
        _idleSince = Situation.Time;
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

    /// <summary>MISSION_START: armed, in AUTO or into it.</summary>
    public bool TryStartMission()
    {
        if (!IsArmed || !Auto.HasMission || !TrySetMode((uint)CopterMode.Auto))
            return false;
        Auto.Start(Situation);
        return true;
    }

    /// <summary>Another item of the mission is the current one.</summary>
    public void JumpTo(int sequence) => Auto.JumpTo(Situation, sequence, IsAuto);

    /// <summary>The command for the next step.</summary>
    public MotionCommand Step(in VehicleSenses senses)
    {
        FlightSituation situation = Situation;
        Failsafes.Step(
            senses, senses.IsRadioReceived || Switch.IsOverridden(senses.Time), situation.StepSeconds);
        Switch.Step(senses);
        situation.HasPosition = HasPosition;
        if (!IsArmed)
        {
            _checks.Step();
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
        _landing.Step(situation, command);
        DisarmWhereDone();
        return command;
    }

    private void Enter(CopterMode mode)
    {
        Mode = mode;
        _flight = mode switch
        {
            CopterMode.Guided => Guided,
            CopterMode.Auto => Auto,
            CopterMode.Rtl => _return,
            CopterMode.Land => _land,
            _ => _hold,
        };
        _flight.Enter(Situation);
        Failsafes.Fence.ReportModeChange();
        ModeChanged?.Invoke();
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
        bool isForgotten = delay > 0 && !_flight.IsTakingOff && (Situation.Time - _idleSince).ExactSeconds >= delay;
        if ((_flight.DisarmsWhenLanded && _landing.IsDone) || isForgotten)
            Disarm();
    }

    private void Disarm()
    {
        IsArmed = false;
        _landing.Reset();
        _say(MavSeverity.Info, "Disarming motors");
    }
}
