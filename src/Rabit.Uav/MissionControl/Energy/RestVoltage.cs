using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// The voltage of a cell without its load, V + I R, the mean of some seconds. No I/O; one thread.
/// </summary>
internal sealed class RestVoltage(EnergyOptions options)
{
    private const double MeanVoltsPerCell = 3.65;
    private const double MeanSeconds = 10;
    private const int UnknownCells = 3;
    private const double VoltsPerCellAtStart = 3.9;

    // Of the drop under an unknown load, which is taken for that of the hover.
    private const double UnknownLoadDeviation = 0.5;

    private readonly InternalResistance _resistance = new();
    private int _cells = options.Cells ?? 0;
    private double _volts = double.NaN;

    /// <summary>The charge that it is that of, 0 to 1; NaN where no voltage is reported.</summary>
    public double Charge => double.IsNaN(_volts) ? double.NaN : CellVoltage.ChargeOf(_volts);

    /// <summary>Standard deviation of it by an unknown load, volts.</summary>
    public double LoadDeviationVolts { get; private set; }

    /// <summary>Takes what is reported of the battery.</summary>
    /// <param name="vehicle">Voltage and current of the pack.</param>
    /// <param name="time">Of the report.</param>
    /// <param name="seconds">Since the last one.</param>
    public void Update(in VehicleState vehicle, TimeSpan time, double seconds)
    {
        double volts = vehicle.BatteryVolts;
        if (!(volts > 0))
            return;
        if (_cells == 0)
            _cells = Math.Max(1, (int)Math.Round(volts / VoltsPerCellAtStart));
        double amperes = vehicle.BatteryAmperes;
        bool isLoadUnknown = double.IsNaN(amperes);
        if (isLoadUnknown)
            amperes = vehicle.IsArmed ? options.HoverWatts / volts : 0;
        else
            _resistance.Update(volts, amperes, _cells, time);
        double drop = amperes * _resistance.Ohms(_cells) / _cells;
        LoadDeviationVolts = isLoadUnknown ? UnknownLoadDeviation * drop : 0;
        double rest = (volts / _cells) + drop;
        _volts = double.IsNaN(_volts) ? rest : _volts + ((rest - _volts) * seconds / (MeanSeconds + seconds));
    }

    /// <summary>Of the pack under a load.</summary>
    public double VoltsUnder(double watts)
    {
        int cells = _cells > 0 ? _cells : UnknownCells;
        double open = MeanVoltsPerCell * cells;
        double drop = _resistance.Ohms(cells) * watts / open;
        return Math.Max(open / 2, open - drop);
    }
}
