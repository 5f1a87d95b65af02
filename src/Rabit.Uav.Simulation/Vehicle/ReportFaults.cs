using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Simulation;

/// <summary>Makes go wrong what the autopilot reports, while it flies by what it knows.</summary>
internal sealed class ReportFaults(FaultScript script)
{
    // Of an estimator whose measurements fit.
    private const double GoodRatio = 0.05;

    private NedVector? _frozenAt;

    public void Apply(TimeSpan time, ref AutopilotState state)
    {
        state.HidesFix = script.IsOn(ScriptedFaultKind.FixNotReported, time);
        state.HidesPlace = script.IsOn(ScriptedFaultKind.PositionZero, time);
        state.EstimatorRatio = script.ValueOf(ScriptedFaultKind.EstimatorRatio, time) ?? GoodRatio;
        _frozenAt = script.IsOn(ScriptedFaultKind.PositionFrozen, time) ? _frozenAt ?? state.Position : null;
        state.Position = _frozenAt ?? state.Position;
        if (script.ValueOf(ScriptedFaultKind.PositionJump, time) is { } metres)
            state.Position = state.Position.Plus(new NedVector(metres, 0, 0));
        if (script.ValueOf(ScriptedFaultKind.BatteryUnknown, time) is not { } unknown)
            return;
        state.BatteryRemaining = double.NaN;
        if (unknown > 0)
            (state.BatteryVolts, state.BatteryAmperes) = (double.NaN, double.NaN);
    }
}
