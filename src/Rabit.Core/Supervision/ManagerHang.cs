using System;
using System.Globalization;

namespace Rabit.Core;

/// <summary>A manager that was found to hang: it did not return from its code within its limit. Immutable.</summary>
public sealed class ManagerHang
{
    internal ManagerHang(string manager, ManagerStage stage, string? doing, TimeSpan since, TimeSpan duration)
    {
        Manager = manager;
        Stage = stage;
        Doing = doing;
        Since = since;
        Duration = duration;
    }

    /// <summary>The manager.</summary>
    public string Manager { get; }

    /// <summary>Where it hangs.</summary>
    public ManagerStage Stage { get; }

    /// <summary>What it said it was doing (<see cref="RabitManager.Doing"/>); null when it said nothing.</summary>
    public string? Doing { get; }

    /// <summary>When it entered that stage, by <see cref="RabitManager.Now"/>.</summary>
    public TimeSpan Since { get; }

    /// <summary>For how long it had been there when it was found.</summary>
    public TimeSpan Duration { get; }

    /// <inheritdoc/>
    public override string ToString() => string.Format(
        CultureInfo.InvariantCulture,
        "{0} hangs in {1} for {2:0.000} s{3}",
        Manager,
        Stage,
        Duration.TotalSeconds,
        Doing is null ? string.Empty : ": " + Doing);
}
