using System;
using Rabit.Core;

namespace UavConsole;

/// <summary>One entry of the log of the run. Immutable.</summary>
internal sealed class FlightEvent(TimeSpan time, RabitLogKind kind, string source, string text)
{
    /// <summary>By the clock of the run.</summary>
    public TimeSpan Time { get; } = time;

    public RabitLogKind Kind { get; } = kind;

    public string Source { get; } = source;

    public string Text { get; } = text;
}
