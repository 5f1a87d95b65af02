using System;
using Rabit.Core;

namespace Rabit.Uav.Reporting;

/// <summary>One entry of the log of a run. Immutable.</summary>
/// <param name="time">By the clock of the run.</param>
/// <param name="kind">What it is about.</param>
/// <param name="source">The manager that wrote it, or the reactor.</param>
/// <param name="text">What it says.</param>
public sealed class FlightEvent(TimeSpan time, RabitLogKind kind, string source, string text)
{
    /// <summary>By the clock of the run.</summary>
    public TimeSpan Time { get; } = time;

    /// <summary>What it is about.</summary>
    public RabitLogKind Kind { get; } = kind;

    /// <summary>The manager that wrote it, or the reactor.</summary>
    public string Source { get; } = source;

    /// <summary>What it says.</summary>
    public string Text { get; } = text;
}
