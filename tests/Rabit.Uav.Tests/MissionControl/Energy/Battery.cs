using System;
using Rabit.Uav.Messages;
using Rabit.Uav.MissionControl;

namespace Rabit.Uav.Tests.MissionControl.Energy;

/// <summary>What an autopilot reports of the battery beside the time.</summary>
[Flags]
public enum Reported
{
    None = 0,
    Percent = 1,
    Volts = 2,
    Amperes = 4,
    Consumed = 8,
    All = 15,
}

/// <summary>
/// A battery of four cells and 8 Ah that is discharged with 10 and 16 A by turns and reported once a second: whole per
/// cent, counted from what stands on it.
/// </summary>
internal sealed class Battery
{
    private const double StatedAmpereHours = 8;
    private const int Cells = 4;
    private const double Ohms = Cells * 0.006;

    private double _drawn;
    private TimeSpan _time = TimeSpan.FromSeconds(1);
    private double _counted = double.NaN;

    /// <summary>Of its curve from the estimator's.</summary>
    public double CurveOffsetVolts { get; init; }

    public double Charge { get; set; } = 1;

    public double CapacityFraction { get; init; } = 1;

    /// <summary>Added to the percentage.</summary>
    public double PercentOffset { get; set; }

    /// <summary>Of each cell.</summary>
    public double LostVolts { get; set; }

    public Reported Reports { get; set; } = Reported.All;

    public void Discharge(ChargeEstimator estimator, double to)
    {
        while (Charge > to)
        {
            Step();
            estimator.Update(Report());
        }
    }

    public VehicleState Report()
    {
        if (double.IsNaN(_counted))
            _counted = Charge;
        double percent = _counted - (_drawn / StatedAmpereHours) + PercentOffset;
        double cell = CellVoltage.VoltsOf(Charge) + CurveOffsetVolts - LostVolts;
        return new VehicleState
        {
            IsArmed = true,
            BatteryTime = _time,
            BatteryRemaining = Of(Reported.Percent, Math.Max(0, Math.Min(1, Math.Round(percent, 2)))),
            BatteryVolts = Of(Reported.Volts, (Cells * cell) - (Amperes * Ohms)),
            BatteryAmperes = Of(Reported.Amperes, Amperes),
            BatteryConsumedAmpereHours = Of(Reported.Consumed, _drawn),
        };
    }

    private double Amperes => (int)_time.TotalSeconds / 10 % 2 == 0 ? 10 : 16;

    private void Step()
    {
        if (double.IsNaN(_counted))
            _counted = Charge;
        _time += TimeSpan.FromSeconds(1);
        _drawn += Amperes / 3600;
        Charge = Math.Max(0, Charge - (Amperes / 3600 / (StatedAmpereHours * CapacityFraction)));
    }

    private double Of(Reported kind, double value) => (Reports & kind) != 0 ? value : double.NaN;
}
