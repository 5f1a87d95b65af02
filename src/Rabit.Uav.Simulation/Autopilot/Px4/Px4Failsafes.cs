using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>
/// PX4's failsafe framework: conditions with actions, of which the most severe counts; AUTO.LOITER for COM_FAIL_ACT_T
/// before a return or landing begins; a change of the mode by the pilot reduces what stands to a warning.
/// </summary>
internal sealed class Px4Failsafes
{
    private const byte FailsafeLevels = 0x42;
    private const double DelayRecovery = 0.25;   // s/s: FailsafeBase::updateStartDelay

    private readonly Px4Situation _situation;
    private readonly Px4Events _events;
    private readonly Px4FailsafeCondition _manual = new(Px4Cause.ManualControl);
    private readonly Px4FailsafeCondition _ground = new(Px4Cause.GroundStation);
    private readonly Px4FailsafeCondition _low = new(Px4Cause.LowBattery);
    private readonly Px4FailsafeCondition _critical = new(Px4Cause.CriticalBattery);
    private readonly Px4FailsafeCondition _emergency = new(Px4Cause.EmergencyBattery);
    private readonly Px4FailsafeCondition _fence = new(Px4Cause.Generic, lasts: true);
    private readonly Px4FailsafeCondition[] _all;
    private double _delaySeconds;
    private bool _isDelaying;
    private bool _isTakenOver;
    private Px4Cause _cause;

    public Px4Failsafes(Px4Situation situation, Px4Events events)
    {
        _situation = situation;
        _events = events;
        _all = [_emergency, _critical, _fence, _ground, _manual, _low];
        ResetDelay();
    }

    // Where none were received when it armed, their absence is no failsafe.
    private bool WereReceivedInFlight
        => _situation.Sticks.Received
            >= _situation.ArmedAt - TimeSpan.OfSeconds(_situation.Parameters.ManualLossTime.Value);

    /// <summary>What is done now.</summary>
    public Px4Action Action { get; private set; }

    /// <summary>Parameters were changed: as in PX4 the delay is the whole one again.</summary>
    public void ResetDelay() => _delaySeconds = _situation.Parameters.FailsafeDelay.Value;

    /// <summary>It has disarmed: nothing stands.</summary>
    public void Reset()
    {
        foreach (Px4FailsafeCondition condition in _all)
            condition.Clear();
        Action = Px4Action.None;
        _isTakenOver = false;
        _isDelaying = false;
        ResetDelay();
    }

    /// <summary>The pilot or a ground station has changed the mode.</summary>
    public void ChangeMode()
    {
        bool isTrue = false;
        foreach (Px4FailsafeCondition condition in _all)
        {
            condition.ChangeMode();
            isTrue |= condition.IsPresent && condition.Action > Px4Action.Warn;
        }

        if (isTrue && !_isTakenOver)
            _events.Send(Px4Event.TookOverInFailsafe, 0x66);
        _isTakenOver = isTrue;
        _isDelaying = false;
        if (Action > Px4Action.Warn)
            Action = isTrue ? Px4Action.Warn : Px4Action.None;
    }

    /// <summary>Takes in what is so now.</summary>
    /// <param name="intention">The mode that the pilot or a ground station has chosen.</param>
    /// <param name="checks">What the checks have found.</param>
    public void Check(Px4Mode intention, Px4Checks checks)
    {
        Px4Parameters parameters = _situation.Parameters;
        bool isNew = _manual.Update(
            checks.IsManualControlLost && WereReceivedInFlight && !IsExcepted(intention),
            LinkAction(parameters.ManualLossAction.Whole));
        isNew |= _ground.Update(checks.IsGroundStationLost, LinkAction(parameters.GroundStationLossAction.Whole));
        isNew |= _fence.Update(checks.IsFenceBreached, FenceAction(parameters.FenceAction.Whole));
        MavBatteryChargeState charge = checks.Charge;
        isNew |= _low.Update(charge == MavBatteryChargeState.Low, Px4Action.Warn);
        int battery = parameters.LowBatteryAction.Whole;
        isNew |= _critical.Update(
            charge == MavBatteryChargeState.Critical,
            battery == 3 ? Px4Action.Return : battery == 2 ? Px4Action.Land : Px4Action.Warn);
        isNew |= _emergency.Update(
            charge == MavBatteryChargeState.Emergency, battery is 2 or 3 ? Px4Action.Land : Px4Action.Warn);
        if (isNew)
            _isTakenOver = false;
    }

    /// <summary>What is to be done in this step.</summary>
    public void Step(Px4Mode intention)
    {
        Px4FailsafeCondition? worst = MostSevere();
        Px4Action action = worst?.Action ?? Px4Action.None;
        if (worst is null)
            _isTakenOver = false;
        if (action > Px4Action.Warn && (_isTakenOver || action <= Equivalent(intention)))
            action = Px4Action.Warn;
        bool delays = action is Px4Action.Return or Px4Action.Land && _delaySeconds > 0
            && Action is not (Px4Action.Return or Px4Action.Land);
        _delaySeconds = delays
            ? Math.Max(0, _delaySeconds - _situation.StepSeconds)
            : Math.Min(
                _situation.Parameters.FailsafeDelay.Value,
                _delaySeconds + (DelayRecovery * _situation.StepSeconds));
        if (worst is not null && !delays && action > Px4Action.Warn)
            worst.IsActivated = true;
        Take(intention, action, worst?.Cause ?? Px4Cause.Generic, delays);
    }

    /// <summary>An action that stands for a mode that cannot be flown: reported at once, without a delay.</summary>
    public void ReportFallback(Px4Mode intention, Px4Action action)
        => _events.Send(
            Px4Event.FailsafeGeneric, FailsafeLevels,
            default(Px4EventArguments).UInt32((uint)intention).Byte((int)action), "Failsafe activated");

    private void Take(Px4Mode intention, Px4Action action, Px4Cause cause, bool delays)
    {
        Px4Action taken = delays ? Px4Action.Hold : action;
        bool isWorse = taken > Action || (taken != Px4Action.None && cause != _cause && !_isTakenOver)
            || (delays && !_isDelaying);
        if (isWorse)
            Report(intention, action, cause, delays);
        Action = taken;
        _cause = cause;
        _isDelaying = delays;
    }

    private void Report(Px4Mode intention, Px4Action action, Px4Cause cause, bool delays)
    {
        Px4EventArguments arguments = default(Px4EventArguments).UInt32((uint)intention);
        if (delays)
        {
            var seconds = (int)Math.Round(_delaySeconds);
            arguments = arguments.Byte((int)action).UInt16(seconds);
            string text = FormattableString.Invariant($"Failsafe activated, entering Hold for {seconds} seconds");
            if (cause == Px4Cause.Generic)
                _events.Send(Px4Event.FailsafeGenericHold, FailsafeLevels, arguments, text);
            else
                _events.Send(Px4Event.FailsafeHold, FailsafeLevels, arguments.Byte((int)cause), text);
        }
        else if (action == Px4Action.Warn)
        {
            ReportWarning(arguments, cause);
        }
        else if (cause == Px4Cause.Generic)
        {
            _events.Send(Px4Event.FailsafeGeneric, FailsafeLevels, arguments.Byte((int)action), "Failsafe activated");
        }
        else
        {
            arguments = arguments.Byte((int)action).Byte((int)cause);
            _events.Send(Px4Event.Failsafe, FailsafeLevels, arguments, "Failsafe activated");
        }
    }

    private void ReportWarning(Px4EventArguments arguments, Px4Cause cause)
    {
        switch (cause)
        {
            case Px4Cause.LowBattery:
                _events.Send(Px4Event.FailsafeLowBattery, 0x64, text: "Failsafe activated");
                break;
            case Px4Cause.CriticalBattery:
                _events.Send(Px4Event.FailsafeCriticalBatteryWarning, 0x62, text: "Failsafe activated");
                break;
            case Px4Cause.EmergencyBattery:
                _events.Send(Px4Event.FailsafeEmergencyBatteryWarning, 0x60, text: "Failsafe activated");
                break;
            default:
                _events.Send(Px4Event.FailsafeWarning, 0x44, arguments.Byte((int)cause));
                break;
        }
    }

    private Px4FailsafeCondition? MostSevere()
    {
        Px4FailsafeCondition? worst = null;
        foreach (Px4FailsafeCondition condition in _all)
        {
            if (condition.IsPresent && (worst is null || condition.Action > worst.Action))
                worst = condition;
        }

        return worst;
    }

    private bool IsExcepted(Px4Mode intention)
    {
        int bit = intention switch { Px4Mode.Mission => 1, Px4Mode.Loiter => 2, Px4Mode.Offboard => 4, _ => 0 };
        return (_situation.Parameters.ManualLossExceptions.Whole & bit) != 0;
    }

    // What the chosen mode does by itself already.
    private static Px4Action Equivalent(Px4Mode intention) => intention switch
    {
        Px4Mode.Rtl => Px4Action.Return,
        Px4Mode.Land => Px4Action.Land,
        _ => Px4Action.None,
    };

    // NAV_DLL_ACT and NAV_RCL_ACT; terminating and disarming in the air are not simulated.
    private static Px4Action LinkAction(int value) => value switch
    {
        1 => Px4Action.Hold,
        2 => Px4Action.Return,
        3 => Px4Action.Land,
        _ => Px4Action.None,
    };

    private static Px4Action FenceAction(int value) => value switch
    {
        1 => Px4Action.Warn,
        2 => Px4Action.Hold,
        3 => Px4Action.Return,
        5 => Px4Action.Land,
        _ => Px4Action.None,
    };
}
