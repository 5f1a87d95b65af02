using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Messages;
using Rabit.Uav.Preflight;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>The thresholds of Health Monitoring. Read once, when the manager is constructed.</summary>
/// <example>
/// <code>
/// var options = new UavOptions
/// {
///     Health = new HealthOptions { BatteryLowFraction = 0.4, WindHighMetresPerSecond = 9 },
/// };
/// </code>
/// </example>
public sealed class HealthOptions
{
    /// <summary>Remaining fraction of the battery at or below which it is low: return to launch.</summary>
    /// <value>
    /// Above <see cref="BatteryCriticalFraction"/>, below 1. The default is 0.25: before the usual 20 % of ArduPilot's
    /// and PX4's own first warnings.
    /// </value>
    public double BatteryLowFraction { get; set; } = 0.25;

    /// <summary>Remaining fraction of the battery at or below which it is critical: land.</summary>
    /// <value>Above 0. The default is 0.10: PX4 returns by itself near there (BAT_CRIT_THR is 7 %).</value>
    public double BatteryCriticalFraction { get; set; } = 0.10;

    /// <summary>
    /// Cells of the battery in series; null for as many as the autopilot reports one by one, or as the first voltage
    /// makes likely: a battery that is not charged may be taken for one with a cell less.
    /// </summary>
    /// <value>1 to 24, or null, the default.</value>
    public int? BatteryCells { get; set; }

    /// <summary>Voltage of a cell without load, volts, below which the battery is low: return to launch.</summary>
    /// <value>
    /// Above <see cref="BatteryCriticalCellVolts"/>, below 4.5 V. The default is 3.6 V: some 10 % of a lithium polymer
    /// cell. For lithium ion cells 3.2 V and 2.9 V are usual.
    /// </value>
    public double BatteryLowCellVolts { get; set; } = 3.6;

    /// <summary>Voltage of a cell without load, volts, below which the battery is critical: land.</summary>
    /// <value>Above 0. The default is 3.3 V: below it the voltage of a lithium polymer cell collapses.</value>
    public double BatteryCriticalCellVolts { get; set; } = 3.3;

    /// <summary>Satellites below which the fix is poor.</summary>
    /// <value>4 to 50. The default is 6, as PX4 requires (EKF2_REQ_NSATS).</value>
    public int MinSatellites { get; set; } = 6;

    /// <summary>Horizontal dilution of precision (HDOP) above which the fix is poor.</summary>
    /// <value>At least 1. The default is 2.5, as PX4 requires (EKF2_REQ_HDOP).</value>
    public double MaxHorizontalDilution { get; set; } = 2.5;

    /// <summary>
    /// Limit of what the autopilot's estimator reports of velocity, position and height against their measurements;
    /// see <see cref="Messages.NavigationStatus.EstimatorRatio"/>.
    /// </summary>
    /// <value>Above 0.2. The default is 0.8, as ArduPilot's failsafe has it (FS_EKF_THRESH).</value>
    public double MaxEstimatorRatio { get; set; } = 0.8;

    /// <summary>
    /// How far the ways of 5 s by positions and by velocities may end from each other, metres.
    /// </summary>
    /// <value>
    /// At least 3 m. The default is 12 m: estimators correct themselves by 1 to 2 m, that of an ArduCopter of 2013 by
    /// up to 11 m; what flies with 2.4 m/s or more is found.
    /// </value>
    public double PositionErrorMetres { get; set; } = 12;

    /// <summary>
    /// How far the height above home and that by the air pressure may differ, metres, beside 15 % of the height.
    /// </summary>
    /// <value>At least 5 m. The default is 10 m: the weather alone makes some 5 m in half an hour.</value>
    public double HeightErrorMetres { get; set; } = 10;

    /// <summary>
    /// Time without a heartbeat after which the autopilot is lost, whatever Autopilot Interface reports.
    /// </summary>
    /// <value>
    /// At least 1 s. The default is 5 s: four to five missed at 1 Hz (MAVLink guide, "Heartbeat/Connection Protocol").
    /// </value>
    public TimeSpan AutopilotTimeout { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>Time beyond its wake-up delay after which a manager that begins no unit of work is stuck.</summary>
    /// <value>
    /// At least 250 ms. The default is 1 s: with a wake-up delay of up to 1 s our heartbeat stops within 2 s.
    /// </value>
    public TimeSpan StuckAfter { get; set; } = TimeSpan.FromSeconds(1);

    /// <summary>
    /// Time beyond its wake-up delay after which a manager that begins no unit of work makes a vehicle in flight return
    /// to launch.
    /// </summary>
    /// <value>
    /// At least <see cref="StuckAfter"/>. The default is 5 s: a small computer that is busy for a moment is no reason
    /// to abort a mission.
    /// </value>
    public TimeSpan StuckReturnToLaunchAfter { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>How long a fault of a manager, or a dropped frame, is reported.</summary>
    /// <value>
    /// Above zero. The default is 5 s: several times the longest delay of <see cref="Core.FaultPolicy.CarryOn"/>.
    /// </value>
    public TimeSpan RecentWindow { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>Time after which an open link without its first frame is silent.</summary>
    /// <value>Above zero. The default is 5 s, as for a link on which frames stop.</value>
    public TimeSpan FirstFrameTimeout { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>Limit of the wind speed, metres per second, by the autopilot's estimate.</summary>
    /// <value>
    /// Above 0. The default is 12 m/s: the usual rating of small multirotors, well below the speed that they can fly.
    /// </value>
    public double WindHighMetresPerSecond { get; set; } = 12;

    /// <summary>How long the wind may be above its limit: gusts are ignored.</summary>
    /// <value>Zero or more. The default is 5 s.</value>
    public TimeSpan WindHighAfter { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>
    /// Limit of the gusts, metres per second: the strongest wind of the last 10 s, by two estimates of the autopilot.
    /// </summary>
    /// <value>
    /// At least <see cref="WindHighMetresPerSecond"/>. The default is 17 m/s: 1.4 times the limit of the wind, as gusts
    /// are.
    /// </value>
    public double GustHighMetresPerSecond { get; set; } = 17;

    /// <summary>
    /// Time without a heartbeat of a ground station, once one was received, after which it is lost. What the vehicle
    /// does then the mission says: <see cref="MissionControl.MissionPlan.GroundStationLost"/>.
    /// </summary>
    /// <value>At least 2 s. The default is 5 s: five missed at 1 Hz.</value>
    public TimeSpan GroundStationLostAfter { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>Temperature of the computer from which it is hot, degrees Celsius: a warning.</summary>
    /// <value>The default is 75: a Raspberry Pi lowers its clock from 80 degrees.</value>
    public double ComputerHotCelsius { get; set; } = 75;

    /// <summary>Temperature of the computer from which the vehicle returns to launch, degrees Celsius.</summary>
    /// <value>
    /// Above <see cref="ComputerHotCelsius"/>. The default is 84, for a Raspberry Pi; a Jetson is made for more.
    /// </value>
    public double ComputerTooHotCelsius { get; set; } = 84;

    /// <summary>Fraction of the memory in use above which it is low: a warning.</summary>
    /// <value>Between 0 and 1. The default is 0.85.</value>
    public double MemoryLowFraction { get; set; } = 0.85;

    /// <summary>Free space below which the disk is nearly full, bytes: a warning.</summary>
    /// <value>At least <see cref="DiskFullBytes"/>. The default is 1 GB.</value>
    public long DiskLowBytes { get; set; } = 1_000_000_000;

    /// <summary>Free space below which ONBOARD_COMPUTER_STATUS reports the disk as full, bytes.</summary>
    /// <value>Zero or more. The default is 200 MB.</value>
    public long DiskFullBytes { get; set; } = 200_000_000;

    /// <summary>The directory whose disk is watched: where logs and pictures are written.</summary>
    /// <value>The default is ".", the current directory at the start.</value>
    public string DataDirectory { get; set; } = ".";

    /// <summary>Time without a picture during a search after which the camera is silent.</summary>
    /// <value>Above zero. The default is 3 s: six pictures at 2 Hz.</value>
    public TimeSpan CameraSilentAfter { get; set; } = TimeSpan.FromSeconds(3);

    /// <summary>Fraction of usable pictures at or below which a search cannot go on.</summary>
    /// <value>Above 0, below 0.8. The default is 0.5.</value>
    public double PicturesUsableFraction { get; set; } = 0.5;

    /// <summary>How long that holds before the vehicle holds, and how long the opposite before it goes on.</summary>
    /// <value>Zero or more. The default is 1 s: with the pictures that the fraction is of, 2 s and a half.</value>
    public TimeSpan PicturesUnusableAfter { get; set; } = TimeSpan.FromSeconds(1);

    /// <summary>How long pictures may be unusable in all before the vehicle returns to launch.</summary>
    /// <value>Above <see cref="PicturesUnusableAfter"/>. The default is 20 s.</value>
    public TimeSpan PicturesUnusableReturnAfter { get; set; } = TimeSpan.FromSeconds(20);

    /// <summary>Minimum time between two texts about our health to the ground station (STATUSTEXT).</summary>
    /// <value>Above zero. The default is 5 s.</value>
    public TimeSpan StatusTextPeriod { get; set; } = TimeSpan.FromSeconds(5);

    /// <summary>What the loss of the ground station leads to. Set where the system is composed.</summary>
    internal GroundStationLoss GroundStationLoss { get; set; } = new();

    /// <summary>Figures of the computer; null for none. Set where the system is composed.</summary>
    internal IReaderSource<ComputerStatus>? Computer { get; set; }

    /// <summary>Whether Communications records the links. Set where the system is composed.</summary>
    internal bool WatchesRecording { get; set; }

    /// <summary>The pre-flight checklist; null where there is none. Set where the system is composed.</summary>
    internal PreflightOptions? Preflight { get; set; }

    /// <summary>
    /// The manager by whose posts the camera is judged; null where there is none. Set where the system is composed.
    /// </summary>
    internal string? CameraManager { get; set; }

    /// <exception cref="ArgumentException">Options are out of their range; the text names all of them.</exception>
    internal HealthOptions ValidatedCopy(string parameter)
    {
        List<string> faults = FindFaults().ToList();
        if (faults.Count > 0)
            throw new ArgumentException("Health Monitoring: " + string.Join("; ", faults) + ".", parameter);
        return (HealthOptions)MemberwiseClone();
    }

    internal HealthOptions Copy() => (HealthOptions)MemberwiseClone();

    internal IEnumerable<string> FindFaults()
    {
        if (!(BatteryLowFraction > 0 && BatteryLowFraction < 1))
            yield return FormattableString.Invariant(
                $"{nameof(BatteryLowFraction)} is {BatteryLowFraction}; it must be between 0 and 1");
        if (!(BatteryCriticalFraction > 0 && BatteryCriticalFraction < BatteryLowFraction))
        {
            yield return FormattableString.Invariant(
                $"{nameof(BatteryCriticalFraction)} is {BatteryCriticalFraction}; it must be above 0 and below {nameof(BatteryLowFraction)}");
        }

        foreach (string fault in FindFaultsOfPosition())
            yield return fault;
        if (AutopilotTimeout < TimeSpan.FromSeconds(1))
            yield return $"{nameof(AutopilotTimeout)} is {AutopilotTimeout}; heartbeats come once a second: it must be "
                + "at least that";
        if (StuckAfter < HealthManager.EvaluationPeriod)
        {
            yield return $"{nameof(StuckAfter)} is {StuckAfter}; it must be at least the "
                + $"{HealthManager.EvaluationPeriod} after which the rules are evaluated again";
        }

        if (StuckReturnToLaunchAfter < StuckAfter)
            yield return $"{nameof(StuckReturnToLaunchAfter)} is {StuckReturnToLaunchAfter}; it must be at least "
                + $"{nameof(StuckAfter)}";
        if (RecentWindow <= TimeSpan.Zero)
            yield return $"{nameof(RecentWindow)} is {RecentWindow}; it must be above zero";
        if (FirstFrameTimeout <= TimeSpan.Zero)
            yield return $"{nameof(FirstFrameTimeout)} is {FirstFrameTimeout}; it must be above zero";
        if (!(WindHighMetresPerSecond > 0 && !double.IsInfinity(WindHighMetresPerSecond)))
        {
            yield return FormattableString.Invariant(
                $"{nameof(WindHighMetresPerSecond)} is {WindHighMetresPerSecond}; it must be above 0");
        }

        if (WindHighAfter < TimeSpan.Zero)
            yield return $"{nameof(WindHighAfter)} is {WindHighAfter}; it cannot be negative";
        if (!(GustHighMetresPerSecond >= WindHighMetresPerSecond && !double.IsInfinity(GustHighMetresPerSecond)))
        {
            yield return FormattableString.Invariant(
                $"{nameof(GustHighMetresPerSecond)} is {GustHighMetresPerSecond}; it must be at least {nameof(WindHighMetresPerSecond)}");
        }

        foreach (string fault in FindFaultsOfComputer())
            yield return fault;
        if (CameraSilentAfter <= TimeSpan.Zero)
            yield return $"{nameof(CameraSilentAfter)} is {CameraSilentAfter}; it must be above zero";
        if (!(PicturesUsableFraction > 0 && PicturesUsableFraction < 0.8))
            yield return FormattableString.Invariant(
                $"{nameof(PicturesUsableFraction)} is {PicturesUsableFraction}; it must be above 0 and below 0.8");
        if (PicturesUnusableAfter < TimeSpan.Zero || PicturesUnusableReturnAfter <= PicturesUnusableAfter)
            yield return $"{nameof(PicturesUnusableAfter)} is {PicturesUnusableAfter} and "
                + $"{nameof(PicturesUnusableReturnAfter)} {PicturesUnusableReturnAfter}; they must not be negative and "
                + "in this order";
        if (StatusTextPeriod <= TimeSpan.Zero)
            yield return $"{nameof(StatusTextPeriod)} is {StatusTextPeriod}; it must be above zero";
    }
    private IEnumerable<string> FindFaultsOfComputer()
    {
        if (GroundStationLostAfter < TimeSpan.FromSeconds(2))
            yield return $"{nameof(GroundStationLostAfter)} is {GroundStationLostAfter}; heartbeats come once a "
                + "second: it must be at least 2 s";
        if (!(ComputerHotCelsius > 0 && ComputerTooHotCelsius > ComputerHotCelsius && ComputerTooHotCelsius < 150))
        {
            yield return FormattableString.Invariant(
                $"{nameof(ComputerHotCelsius)} is {ComputerHotCelsius} and {nameof(ComputerTooHotCelsius)} {ComputerTooHotCelsius}; they must be above 0, the second above the first and below 150");
        }

        if (!(MemoryLowFraction > 0 && MemoryLowFraction < 1))
            yield return FormattableString.Invariant(
                $"{nameof(MemoryLowFraction)} is {MemoryLowFraction}; it must be between 0 and 1");
        if (DiskFullBytes < 0 || DiskLowBytes < DiskFullBytes)
            yield return FormattableString.Invariant(
                $"{nameof(DiskFullBytes)} is {DiskFullBytes} and {nameof(DiskLowBytes)} {DiskLowBytes}; the first must be 0 or more, the second not less");
        if (string.IsNullOrWhiteSpace(DataDirectory))
            yield return $"{nameof(DataDirectory)} is empty; \".\" is the current one";
    }

    private IEnumerable<string> FindFaultsOfPosition()
    {
        if (BatteryCells is < 1 or > 24)
            yield return $"{nameof(BatteryCells)} is {BatteryCells}; it must be 1 to 24, or null";
        if (!(BatteryLowCellVolts < 4.5))
            yield return Fault(nameof(BatteryLowCellVolts), BatteryLowCellVolts, "it must be below 4.5");
        if (!(BatteryCriticalCellVolts > 0 && BatteryCriticalCellVolts < BatteryLowCellVolts))
        {
            yield return Fault(
                nameof(BatteryCriticalCellVolts), BatteryCriticalCellVolts,
                $"it must be above 0 and below {nameof(BatteryLowCellVolts)}");
        }

        if (MinSatellites is < 4 or > 50)
            yield return Fault(nameof(MinSatellites), MinSatellites, "it must be 4 to 50");
        if (!(MaxHorizontalDilution >= 1))
            yield return Fault(nameof(MaxHorizontalDilution), MaxHorizontalDilution, "it must be at least 1");
        if (!(MaxEstimatorRatio > 0.2))
            yield return Fault(nameof(MaxEstimatorRatio), MaxEstimatorRatio, "it must be above 0.2");
        if (!(PositionErrorMetres >= 3))
            yield return Fault(nameof(PositionErrorMetres), PositionErrorMetres, "it must be at least 3");
        if (!(HeightErrorMetres >= 5))
            yield return Fault(nameof(HeightErrorMetres), HeightErrorMetres, "it must be at least 5");
    }

    private static string Fault(string name, double value, string rule)
        => FormattableString.Invariant($"{name} is {value}; {rule}");
}
