using System;
using System.Collections.Generic;
using System.Threading;
using Microsoft.Extensions.Hosting;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>
/// What the configuration may say of a reactor: section "Rabit", or "Rabit:NAME" for a named one. Times are written as
/// <c>00:00:02.5</c>.
/// </summary>
public sealed class RabitHostOptions
{
    /// <summary>Whether every unit of work is logged, at the level Trace.</summary>
    /// <value>The default is false.</value>
    public bool LogRuns { get; set; }

    /// <summary>As <see cref="ReactorOptions.KeepsStatistics"/>.</summary>
    /// <value>The default is true.</value>
    public bool KeepsStatistics { get; set; } = true;

    /// <summary>As <see cref="ReactorOptions.MaxStopDelay"/>.</summary>
    /// <value>The default is zero.</value>
    public TimeSpan MaxStopDelay { get; set; }

    /// <summary>As <see cref="ReactorOptions.StopTimeout"/>: for each manager.</summary>
    /// <value>The default is 2 s.</value>
    public TimeSpan StopTimeout { get; set; } = TimeSpan.FromSeconds(2);

    /// <summary>
    /// As <see cref="ReactorOptions.TotalStopTimeout"/>: for all managers together. With <see cref="MaxStopDelay"/>
    /// it must be below the host's <see cref="HostOptions.ShutdownTimeout"/>.
    /// </summary>
    /// <value>Null, the default: 10 s, or what the host's time leaves, if that is less.</value>
    public TimeSpan? TotalStopTimeout { get; set; }

    /// <summary>How long a unit of work may take before its manager hangs; zero for no limit.</summary>
    /// <value>Null, the default: that of <see cref="HangPolicy.Report"/>.</value>
    public TimeSpan? UnitOfWorkLimit { get; set; }

    /// <summary>Whether a manager that hangs stops the reactor, and so the host.</summary>
    /// <value>The default is false.</value>
    public bool StopsOnHang { get; set; }

    /// <summary>The time that the host leaves for the stop; a little is kept for the others.</summary>
    internal static TimeSpan Usable(TimeSpan shutdownTimeout)
        => TimeSpan.FromTicks(WholeStop(shutdownTimeout).Ticks / 5 * 4);

    /// <summary>How long the stop of the host may take; an hour where it has no limit.</summary>
    internal static TimeSpan WholeStop(TimeSpan shutdownTimeout)
        => shutdownTimeout == Timeout.InfiniteTimeSpan || shutdownTimeout > TimeSpan.FromHours(1)
            ? TimeSpan.FromHours(1)
            : shutdownTimeout;

    internal ReactorOptions ToReactor(string name, TimeSpan usable) => new()
    {
        Name = name,
        LogRuns = LogRuns,
        KeepsStatistics = KeepsStatistics,
        MaxStopDelay = MaxStopDelay,
        StopTimeout = StopTimeout,
        TotalStopTimeout = TotalStopTimeout ?? Shorter(TimeSpan.FromSeconds(10), usable - MaxStopDelay),
        HangPolicy = ToHangPolicy(),
        StopsOnSignals = false,   // the host does
    };

    /// <param name="section">Where the settings are.</param>
    /// <param name="usable">Of the host's time to stop.</param>
    internal IEnumerable<string> FindFaults(string section, TimeSpan usable)
    {
        TimeSpan hour = TimeSpan.FromHours(1);
        if (StopTimeout <= TimeSpan.Zero || StopTimeout > hour)
            yield return $"{section}:{nameof(StopTimeout)} is {StopTimeout}; it must be above zero and at most an hour";
        if (MaxStopDelay < TimeSpan.Zero || MaxStopDelay > hour)
            yield return $"{section}:{nameof(MaxStopDelay)} is {MaxStopDelay}; it must be 0 to an hour";
        else if (MaxStopDelay >= usable)
            yield return $"{section}:{nameof(MaxStopDelay)} is {MaxStopDelay}; the host leaves {usable} for its stop "
                + "(HostOptions.ShutdownTimeout)";
        if (TotalStopTimeout is { } total && (total <= TimeSpan.Zero || total > hour))
            yield return $"{section}:{nameof(TotalStopTimeout)} is {total}; it must be above zero and at most an hour";
        else if (TotalStopTimeout is { } all && all + MaxStopDelay > usable && MaxStopDelay < usable)
            yield return $"{section}:{nameof(TotalStopTimeout)} is {all}, with {nameof(MaxStopDelay)} "
                + $"{all + MaxStopDelay}; the host leaves {usable} for its stop (HostOptions.ShutdownTimeout)";
        if (UnitOfWorkLimit is { } limit && limit < TimeSpan.Zero)
            yield return $"{section}:{nameof(UnitOfWorkLimit)} is {limit}; it must be 0, for none, or above";
    }

    private HangPolicy ToHangPolicy()
    {
        HangPolicy policy = StopsOnHang ? HangPolicy.StopSystem : HangPolicy.Report;
        return UnitOfWorkLimit is { } limit
            ? policy.WithLimits(limit == TimeSpan.Zero ? Timeout.InfiniteTimeSpan : limit)
            : policy;
    }

    private static TimeSpan Shorter(TimeSpan a, TimeSpan b) => a < b ? a : b;
}
