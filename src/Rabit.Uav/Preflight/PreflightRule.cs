using System;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Preflight;

/// <summary>One line of the checklist: how it is judged, and what the operator reads of it. Immutable.</summary>
internal abstract class PreflightRule
{
    /// <summary>Name of the line, by which it is overridden.</summary>
    public string Name { get; init; } = string.Empty;

    /// <summary>The make of autopilot that has the line; null for all.</summary>
    public MavAutopilot? Autopilot { get; init; }

    /// <summary>What passes, as text.</summary>
    public string Pass { get; init; } = string.Empty;

    /// <summary>What warns, as text; empty where nothing does.</summary>
    public string Warn { get; init; } = string.Empty;

    /// <summary>What fails, as text; empty where nothing does.</summary>
    public string Fail { get; init; } = string.Empty;

    /// <summary>Why, as text.</summary>
    public string Reason { get; init; } = string.Empty;

    /// <summary>What to do where the line does not pass, as text.</summary>
    public virtual string HowToSet { get; init; } = string.Empty;

    /// <summary>Whether only a fixed wing has the line, or only what is none; null for both.</summary>
    public bool? IsOfFixedWing { get; init; }

    /// <summary>Whether it is a line for this vehicle.</summary>
    public bool IsFor(MavAutopilot autopilot, bool isFixedWing)
        => (Autopilot is null || Autopilot == autopilot) && (IsOfFixedWing is null || IsOfFixedWing == isFixedWing);

    /// <summary>Judges what is known at present.</summary>
    public abstract PreflightJudgement Judge(PreflightFacts facts);
}
