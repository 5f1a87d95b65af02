using System;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>What one message reports of the battery; NaN where it does not know.</summary>
internal readonly struct BatteryReading(
    TimeSpan time, double volts, double amperes, double remaining, double consumedAmpereHours = double.NaN)
{
    public static BatteryReading Unknown => new(TimeSpan.MinValue, double.NaN, double.NaN, double.NaN);

    public TimeSpan Time { get; } = time;

    public double Volts { get; } = volts;

    /// <summary>Discharge positive.</summary>
    public double Amperes { get; } = amperes;

    /// <summary>0 to 1.</summary>
    public double Remaining { get; } = remaining;

    /// <summary>Charge drawn since the autopilot began to count.</summary>
    public double ConsumedAmpereHours { get; } = consumedAmpereHours;

    /// <summary>
    /// The same, with the figures of another reading where this one does not know, if that one is not too old.
    /// </summary>
    public BatteryReading FilledFrom(in BatteryReading other, TimeSpan atMostOlder)
        => other.Time == TimeSpan.MinValue || Time - other.Time > atMostOlder
            ? this
            : new BatteryReading(
                Time, Known(Volts, other.Volts), Known(Amperes, other.Amperes), Known(Remaining, other.Remaining),
                Known(ConsumedAmpereHours, other.ConsumedAmpereHours));

    private static double Known(double figure, double otherwise) => double.IsNaN(figure) ? otherwise : figure;
}
