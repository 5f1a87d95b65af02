using System;
using System.Globalization;
using Rabit.Core.Diagnostics;

namespace Rabit.Core;

/// <summary>One entry of the log of a run. Immutable.</summary>
public sealed class RabitLogEntry
{
    internal RabitLogEntry(TimeSpan time, RabitLogKind kind, string source, string text, Exception? exception)
    {
        Time = time;
        Kind = kind;
        Source = source;
        Text = OneLine.Of(text);   // reasons to stop, too, are the user's
        Exception = exception;
    }

    /// <summary>When, on the clock of the run (<see cref="RabitManager.Now"/>).</summary>
    public TimeSpan Time { get; }

    /// <summary>What it is about.</summary>
    public RabitLogKind Kind { get; }

    /// <summary>The manager, reader, writer or message it is about, or <c>reactor</c>.</summary>
    public string Source { get; }

    /// <summary>One line.</summary>
    public string Text { get; }

    /// <summary>What was thrown, where something was.</summary>
    public Exception? Exception { get; }

    /// <summary>One line: seconds, source, text.</summary>
    public override string ToString() => string.Format(
        CultureInfo.InvariantCulture, "{0,12:0.000000} {1}: {2}", Time.TotalSeconds, Source, Text);
}
