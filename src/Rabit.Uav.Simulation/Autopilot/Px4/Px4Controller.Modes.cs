namespace Rabit.Uav.Simulation;

// Which mode is flown: the chosen one, unless a failsafe wants another or it cannot be flown.
internal sealed partial class Px4Controller
{
    private bool CanBeChosen(Px4Mode mode)
        => !IsMissionMissing(mode)
            && (mode == Px4Mode.Posctl || CanRun(mode));   // POSCTL without a position is flown as ALTCTL

    private bool IsMissionMissing(Px4Mode mode) => mode == Px4Mode.Mission && !Mission.HasMission;

    private bool CanRun(Px4Mode mode)
        => (Situation.HasPosition || !Px4ModeNames.NeedsPosition(mode))
            && (mode != Px4Mode.Offboard || !Checks.IsOffboardStreamLost);

    private void Choose(Px4Mode mode)
    {
        Intention = mode;
        if (!Px4ModeNames.PreventsArming(mode))
            _afterDisarming = mode;
    }

    // The chosen mode, unless a failsafe wants another one or it cannot be flown.
    private void SelectMode()
    {
        Px4Action action = IsArmed ? _failsafes.Action : Px4Action.None;
        Px4Action fallback = Px4Action.None;
        if (IsArmed && action <= Px4Action.Warn && !CanRun(Intention))
            fallback = Possible(FallbackOf(Intention));
        else if (action > Px4Action.Warn)
            action = Possible(action);
        if (fallback != Px4Action.None && fallback != _fallback)
            _failsafes.ReportFallback(Intention, fallback);
        _fallback = fallback;
        Enter(ModeOf(fallback != Px4Action.None ? fallback : action));
    }

    private Px4Action FallbackOf(Px4Mode mode)
    {
        if (mode == Px4Mode.Offboard)
        {
            return Situation.Parameters.OffboardLossAction.Whole switch
            {
                0 => Px4Action.PositionControl,
                1 or 2 => Px4Action.AltitudeControl,
                3 => Px4Action.Return,
                5 => Px4Action.Hold,
                _ => Px4Action.Land,
            };
        }

        return mode == Px4Mode.Posctl ? Px4Action.AltitudeControl : Px4Action.Descend;
    }

    private Px4Action Possible(Px4Action action)
    {
        if (Situation.HasPosition)
            return action;
        return action switch
        {
            Px4Action.PositionControl or Px4Action.AltitudeControl => Px4Action.AltitudeControl,
            _ => Px4Action.Descend,
        };
    }

    private Px4Mode ModeOf(Px4Action action) => action switch
    {
        Px4Action.PositionControl => Px4Mode.Posctl,
        Px4Action.AltitudeControl => Px4Mode.Altctl,
        Px4Action.Hold => Px4Mode.Loiter,
        Px4Action.Return => Px4Mode.Rtl,
        Px4Action.Land or Px4Action.Descend => Px4Mode.Land,
        _ => Intention,
    };

    private void Enter(Px4Mode mode)
    {
        if (mode == Mode)
            return;
        Mode = mode;
        Situation.CommandedSpeed = null;
        _flight = mode switch
        {
            Px4Mode.Altctl => _altitude,
            Px4Mode.Posctl => _position,
            Px4Mode.Orbit => Orbit,
            Px4Mode.Offboard => Offboard,
            Px4Mode.Takeoff => Takeoff,
            Px4Mode.Mission => Mission,
            Px4Mode.Rtl => _return,
            Px4Mode.Land => _land,
            _ => Hold,
        };
        if (!IsArmed)
            return;
        _flight.Enter(Situation);
        if (mode == Px4Mode.Loiter && Checks.IsFenceBreached && Checks.InsideFence is { } inside)
        {
            Hold.GoTo(inside, double.NaN);
            Situation.CommandedSpeed = BackInsideSpeed;
        }
    }

    private void OverrideBySticks()
    {
        const int InAuto = 1;
        const int InOffboard = 2;
        const double PerCent = 0.01;
        double speed = Situation.Sticks.TakeSpeed();
        int bit = Mode == Px4Mode.Offboard ? InOffboard : Px4ModeNames.IsAuto(Mode) ? InAuto : 0;
        if ((Situation.Parameters.StickOverride.Whole & bit) == 0 || Situation.IsLanded
            || speed <= PerCent * Situation.Parameters.StickOverrideSpeed.Value || !CanBeChosen(Px4Mode.Posctl))
        {
            return;
        }

        Choose(Px4Mode.Posctl);
        _failsafes.ChangeMode();
        _events.Send(Px4Event.StickOverride, 0x66, text: "Pilot took over using sticks");
    }
}
