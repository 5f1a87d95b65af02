using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>The state of the battery between two evaluations: how many cells it has.</summary>
internal sealed class BatteryCellWatch
{
    // A charged cell of the kind with the highest voltage (LiHV), and its tolerance; the number of cells that is found
    // is the least.
    private const double MaxCellVolts = 4.36;

    // Less than this is no battery but its monitor.
    private const double MinVolts = 2.5;

    // A good cell with its share of the leads has 5 to 10 milliohm. A greater drop than 0.1 V is not trusted (PX4's
    // BAT1_V_LOAD_DROP is as much at full throttle): a bad cell drops more, and is to be found.
    private const double CellOhms = 0.007;
    private const double MaxLoadDropVolts = 0.1;

    // Where the current is not measured: half of it, as in a hover.
    private const double HoverDropVolts = 0.05;

    private int _cells;

    public BatteryFacts Update(in VehicleState state, TimeSpan now, HealthOptions options, bool isEnergyKnown = false)
    {
        if (state.BatteryCells > 0)
            _cells = state.BatteryCells;
        else if (_cells == 0 && state.BatteryVolts > MinVolts)
            _cells = (int)Math.Ceiling(state.BatteryVolts / MaxCellVolts);
        int cells = options.BatteryCells ?? _cells;
        double volts = cells > 0 && state.BatteryVolts > MinVolts
            ? (state.BatteryVolts / cells) + LoadDrop(state)
            : double.NaN;
        return new BatteryFacts(state, volts, now, isEnergyKnown);
    }

    private static double LoadDrop(in VehicleState state)
    {
        if (double.IsNaN(state.BatteryAmperes))
            return state.IsArmed ? HoverDropVolts : 0;
        return Math.Min(Math.Max(0, state.BatteryAmperes * CellOhms), MaxLoadDropVolts);
    }
}
