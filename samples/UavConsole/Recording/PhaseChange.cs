using System;
using Rabit.Uav.Messages;

namespace UavConsole;

/// <summary>Mission Control began something else. Immutable.</summary>
internal sealed class PhaseChange(TimeSpan time, MissionPhase phase, string? text)
{
    /// <summary>By the clock of the run.</summary>
    public TimeSpan Time { get; } = time;

    public MissionPhase Phase { get; } = phase;

    /// <summary>What Mission Control said of it.</summary>
    public string? Text { get; } = text;
}
