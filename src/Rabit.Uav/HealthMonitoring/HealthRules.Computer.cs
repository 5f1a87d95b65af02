using System;
using System.Linq;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// The companion computer is judged by what it knows of itself; what it does not know is no reason.
internal static partial class HealthRules
{
    private const double HotMarginCelsius = 5;
    private const double MemoryMargin = 0.05;
    private const long BytesPerMegabyte = 1_000_000;

    private static readonly TimeSpan HotDwell = TimeSpan.FromSeconds(5);
    private static readonly TimeSpan ThrottledClearDwell = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan MemoryDwell = TimeSpan.FromSeconds(5);

    public static readonly HealthRule<ComputerFacts>[] OfComputer =
    [
        new(HealthReasons.ComputerHot, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in ComputerFacts c, HealthOptions o) => c.Status.TemperatureCelsius >= o.ComputerHotCelsius,
            Until = static (in ComputerFacts c, HealthOptions o)
                => !(c.Status.TemperatureCelsius >= o.ComputerHotCelsius - HotMarginCelsius),
            Dwell = static _ => HotDwell,
            Figure = static (in ComputerFacts c) => Degrees(c),
            Text = static f => $"computer hot ({f.Figure} degrees Celsius)",
            Condition = static o => $"its processor has {Number(o.ComputerHotCelsius)} degrees Celsius or more",
            End = static o => $"below {Number(o.ComputerHotCelsius - HotMarginCelsius)}, or not known",
            Why = "a Raspberry Pi lowers its clock from 80 degrees",
        },
        new(HealthReasons.ComputerHot, HealthLevel.Warning, HealthAdvice.ReturnToLaunch)
        {
            Supersedes = HealthReasons.ComputerHot,
            When = static (in ComputerFacts c, HealthOptions o)
                => c.Status.TemperatureCelsius >= o.ComputerTooHotCelsius,
            Until = static (in ComputerFacts c, HealthOptions o)
                => !(c.Status.TemperatureCelsius >= o.ComputerTooHotCelsius - HotMarginCelsius),
            Dwell = static _ => HotDwell,
            Figure = static (in ComputerFacts c) => Degrees(c),
            Condition = static o => $"{Number(o.ComputerTooHotCelsius)} degrees or more",
            End = static o => $"below {Number(o.ComputerTooHotCelsius - HotMarginCelsius)}, or not known",
            Why = "at 85 degrees a Raspberry Pi keeps its clock down: pictures are late and the search is worth little",
        },
        new(HealthReasons.ComputerThrottled, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in ComputerFacts c, HealthOptions _) => c.Throttling != ComputerThrottling.None,
            ClearDwell = static _ => ThrottledClearDwell,
            Figure = static (in ComputerFacts c) => (long)c.Throttling,
            Text = static f => $"computer throttled ({ThrottlingText((ComputerThrottling)f.Figure)})",
            Condition = static _ => "its firmware reports under-voltage, a capped clock, throttling or the soft limit "
                + "of the temperature, now",
            End = static _ => $"none of them for {Seconds(ThrottledClearDwell)}",
            Why = "a computer that fails for want of voltage is what the autopilot's failsafe for our loss is for",
        },
        new(HealthReasons.MemoryLow, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in ComputerFacts c, HealthOptions o) => c.Status.MemoryUsedFraction > o.MemoryLowFraction,
            Until = static (in ComputerFacts c, HealthOptions o)
                => !(c.Status.MemoryUsedFraction > o.MemoryLowFraction - MemoryMargin),
            Dwell = static _ => MemoryDwell,
            Figure = static (in ComputerFacts c) => Percent(c.Status.MemoryUsedFraction),
            Text = static f => $"memory low ({f.Figure} % used)",
            Condition = static o => $"more than {PercentText(o.MemoryLowFraction)} of it is used",
            End = static o => $"{PercentText(o.MemoryLowFraction - MemoryMargin)} or less, or not known",
            Why = "then pictures wait for memory; the managers themselves allocate nothing in flight",
        },
        new(HealthReasons.DiskLow, HealthLevel.Warning, HealthAdvice.None)
        {
            When = static (in ComputerFacts c, HealthOptions o) => c.Status.DiskFreeBytes < o.DiskLowBytes,
            Until = static (in ComputerFacts c, HealthOptions o)
                => !(c.Status.DiskFreeBytes < o.DiskLowBytes + (o.DiskLowBytes / 10)),
            Figure = static (in ComputerFacts c) => Megabytes(c),
            Text = static f => $"disk nearly full ({f.Figure} MB free)",
            Condition = static o => "where logs are written there are less than "
                + $"{o.DiskLowBytes / BytesPerMegabyte} MB free",
            End = static o => "a tenth more than that",
            Why = "half an hour of pictures at 2 Hz; a flight does not need the disk, its record does",
        },
    ];

    // Whole degrees, and downwards: 74.9 is not yet 75.
    private static long Degrees(in ComputerFacts computer) => (long)Math.Floor(computer.Status.TemperatureCelsius);

    // In steps of 100 MB, so that a disk that fills is not another finding at each look.
    private static long Megabytes(in ComputerFacts computer)
        => (computer.Status.DiskFreeBytes ?? 0) / (100 * BytesPerMegabyte) * 100;

    private static string ThrottlingText(ComputerThrottling throttling) => string.Join(", ", new[]
    {
        (ComputerThrottling.UnderVoltage, "under-voltage"), (ComputerThrottling.FrequencyCapped, "clock capped"),
        (ComputerThrottling.Throttled, "clock lowered"),
        (ComputerThrottling.SoftTemperatureLimit, "soft limit of the temperature"),
    }.Where(t => (throttling & t.Item1) != 0).Select(t => t.Item2));
}
