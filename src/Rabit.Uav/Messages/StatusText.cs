using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Messages;

/// <summary>A text that a vehicle sent for people (STATUSTEXT). Immutable.</summary>
public sealed class StatusText
{
    /// <summary>Makes one.</summary>
    /// <param name="time">When it came in, by the clock of the run.</param>
    /// <param name="severity">How severe.</param>
    /// <param name="text">The text, whole; "…" stands for chunks that were lost.</param>
    public StatusText(TimeSpan time, MavSeverity severity, string text)
    {
        Time = time;
        Severity = severity;
        Text = text ?? throw new ArgumentNullException(nameof(text));
    }

    /// <summary>When it came in, by the clock of the run.</summary>
    public TimeSpan Time { get; }

    /// <summary>How severe.</summary>
    public MavSeverity Severity { get; }

    /// <summary>The text, whole; "…" stands for chunks that were lost.</summary>
    public string Text { get; }
}
