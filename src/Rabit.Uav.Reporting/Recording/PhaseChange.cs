using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>The start of a phase of the mission. Immutable.</summary>
/// <param name="time">By the clock of the run.</param>
/// <param name="phase">The new phase.</param>
/// <param name="text">What Mission Control said of it.</param>
public sealed class PhaseChange(TimeSpan time, MissionPhase phase, string? text)
{
    /// <summary>By the clock of the run.</summary>
    public TimeSpan Time { get; } = time;

    /// <summary>The new phase.</summary>
    public MissionPhase Phase { get; } = phase;

    /// <summary>What Mission Control said of it; null for nothing.</summary>
    public string? Text { get; } = text;
}
