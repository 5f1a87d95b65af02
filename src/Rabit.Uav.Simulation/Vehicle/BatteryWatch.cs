namespace Rabit.Uav.Simulation;

/// <summary>
/// Watches a battery against two limits of its voltage, each of which must be passed for some time, and two of the
/// charge that is left. The most severe level stays, also when the voltage is back.
/// </summary>
internal sealed class BatteryWatch
{
    private double _lowSeconds;
    private double _criticalSeconds;

    public BatteryLevel Level { get; private set; }

    /// <summary>One step; whether the level has become more severe.</summary>
    /// <param name="parameters">The limits.</param>
    /// <param name="volts">As measured.</param>
    /// <param name="milliampereHoursLeft">As counted.</param>
    /// <param name="stepSeconds">The length of the step.</param>
    public bool Step(BatteryParameters parameters, double volts, double milliampereHoursLeft, double stepSeconds)
    {
        double timer = parameters.LowTimer.Value;
        _lowSeconds = IsBelow(volts, parameters.LowVolts) ? _lowSeconds + stepSeconds : 0;
        _criticalSeconds = IsBelow(volts, parameters.CriticalVolts) ? _criticalSeconds + stepSeconds : 0;
        BatteryLevel level = BatteryLevel.Ok;
        if ((timer > 0 && _criticalSeconds > timer) || IsBelow(milliampereHoursLeft, parameters.CriticalCharge))
            level = BatteryLevel.Critical;
        else if ((timer > 0 && _lowSeconds > timer) || IsBelow(milliampereHoursLeft, parameters.LowCharge))
            level = BatteryLevel.Low;
        if (level <= Level)
            return false;
        Level = level;
        return true;
    }

    /// <summary>Whether a value is below a limit; a limit of zero is none.</summary>
    public static bool IsBelow(double value, Parameter limit) => limit.Value > 0 && value < limit.Value;
}
