using System;
using System.Collections.Generic;
using System.Linq;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>The thresholds of Health Monitoring. Read once, when the manager is made.</summary>
public sealed class HealthOptions
{
    /// <summary>At what rest, or below, the battery is low, 0 to 1.</summary>
    /// <value>The default is 0.25: at the usual 20 % of ArduPilot's and PX4's own first warnings the operator should know already.</value>
    public double BatteryLow { get; set; } = 0.25;

    /// <summary>At what rest, or below, the battery is nearly empty, 0 to 1.</summary>
    /// <value>The default is 0.10: PX4 returns home by itself near there (BAT_CRIT_THR is 7 %).</value>
    public double BatteryCritical { get; set; } = 0.10;

    /// <summary>After what time without a heartbeat the autopilot is lost, whatever Autopilot Interface says.</summary>
    /// <value>The default is 5 s: four to five missed at 1 Hz (MAVLink guide, "Heartbeat/Connection Protocol").</value>
    public TimeSpan AutopilotTimeout { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>How much longer than its wake-up delay a manager may go without beginning a unit of work before it is stuck.</summary>
    /// <value>The default is 1 s: with a wake-up delay of up to 1 s our heartbeat stops within 2 s.</value>
    public TimeSpan StuckAfter { get; set; } = TimeSpan.FromSeconds(1);

    /// <summary>How much longer than its wake-up delay a manager may go without beginning a unit of work before a vehicle in flight should come home.</summary>
    /// <value>The default is 5 s: a small computer that was busy for a moment is no reason to give a mission up.</value>
    public TimeSpan StuckReturnToLaunchAfter { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>How long a fault of a manager, or a dropped frame, is told of.</summary>
    /// <value>The default is 5 s: several times the longest delay of <see cref="Core.FaultPolicy.CarryOn"/>.</value>
    public TimeSpan RememberedFor { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>How long an open link may stay without its first frame before it is called silent.</summary>
    /// <value>The default is 5 s, as for a link that falls silent.</value>
    public TimeSpan FirstFrameWithin { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>How strong the wind may be, metres per second, by the autopilot's estimate.</summary>
    /// <value>The default is 12 m/s: what small multirotors are usually rated for, and well below what they can fly against.</value>
    public double WindHigh { get; set; } = 12;

    /// <summary>How long it may be stronger: a gust is no storm.</summary>
    /// <value>The default is 5 s.</value>
    public TimeSpan WindHighAfter { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>How long the camera may be without a picture while it should search.</summary>
    /// <value>The default is 3 s: six pictures at 2 Hz.</value>
    public TimeSpan CameraSilentAfter { get; set; } = TimeSpan.FromSeconds(3);

    /// <summary>How often, at the most, a text about our health goes to the ground (STATUSTEXT).</summary>
    /// <value>The default is 5 s.</value>
    public TimeSpan StatusTextPeriod { get; set; } = TimeSpan.FromSeconds(5);

    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    internal HealthOptions ValidatedCopy(string parameter)
    {
        List<string> faults = FindFaults().ToList();
        if (faults.Count > 0)
            throw new ArgumentException("Health Monitoring: " + string.Join("; ", faults) + ".", parameter);
        return (HealthOptions)MemberwiseClone();
    }

    private IEnumerable<string> FindFaults()
    {
        if (!(BatteryLow > 0 && BatteryLow < 1))
            yield return FormattableString.Invariant($"{nameof(BatteryLow)} is {BatteryLow}; it must be between 0 and 1");
        if (!(BatteryCritical > 0 && BatteryCritical < BatteryLow))
            yield return FormattableString.Invariant($"{nameof(BatteryCritical)} is {BatteryCritical}; it must be above 0 and below {nameof(BatteryLow)}");
        if (AutopilotTimeout < TimeSpan.FromSeconds(1))
            yield return $"{nameof(AutopilotTimeout)} is {AutopilotTimeout}; heartbeats come once a second, so it must be at least that";
        if (StuckAfter < HealthManager.Cycle)
            yield return $"{nameof(StuckAfter)} is {StuckAfter}; the rules are judged every {HealthManager.Cycle}, so it must be at least that";
        if (StuckReturnToLaunchAfter < StuckAfter)
            yield return $"{nameof(StuckReturnToLaunchAfter)} is {StuckReturnToLaunchAfter}; it must be at least {nameof(StuckAfter)}";
        if (RememberedFor <= TimeSpan.Zero)
            yield return $"{nameof(RememberedFor)} is {RememberedFor}; it must be above zero";
        if (FirstFrameWithin <= TimeSpan.Zero)
            yield return $"{nameof(FirstFrameWithin)} is {FirstFrameWithin}; it must be above zero";
        if (!(WindHigh > 0 && !double.IsInfinity(WindHigh)))
            yield return FormattableString.Invariant($"{nameof(WindHigh)} is {WindHigh}; it must be above 0");
        if (WindHighAfter < TimeSpan.Zero)
            yield return $"{nameof(WindHighAfter)} is {WindHighAfter}; it cannot be negative";
        if (CameraSilentAfter <= TimeSpan.Zero)
            yield return $"{nameof(CameraSilentAfter)} is {CameraSilentAfter}; it must be above zero";
        if (StatusTextPeriod <= TimeSpan.Zero)
            yield return $"{nameof(StatusTextPeriod)} is {StatusTextPeriod}; it must be above zero";
    }
}
