namespace Companion._1;

/// <summary>The settings of <see cref="BatteryAlarm"/>.</summary>
public sealed class BatteryAlarmOptions
{
    /// <summary>Where they are in the configuration.</summary>
    public const string Section = "BatteryAlarm";

    /// <summary>What remains when it warns: 0.3 is 30 percent.</summary>
    public double LevelFraction { get; set; } = 0.3;
}
