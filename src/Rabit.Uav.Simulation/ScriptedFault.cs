using System;

namespace Rabit.Uav.Simulation;

/// <summary>Something that goes wrong at a set time. A plain value.</summary>
/// <example>
/// <code>
/// var silence = new ScriptedFault
/// {
///     Kind = ScriptedFaultKind.LinkSilent,
///     At = TimeSpan.FromSeconds(60),
///     Duration = TimeSpan.FromSeconds(10),
/// };
/// </code>
/// </example>
public struct ScriptedFault
{
    /// <summary>What.</summary>
    public ScriptedFaultKind Kind { get; set; }

    /// <summary>When it begins, by the clock of the run.</summary>
    public TimeSpan At { get; set; }

    /// <summary>How long it lasts, where it ends again.</summary>
    public TimeSpan Duration { get; set; }

    /// <summary>What it is about; see <see cref="ScriptedFaultKind"/>.</summary>
    public double Value { get; set; }

    /// <summary>The manager that it is about; see <see cref="ScriptedFaultKind.ManagerHangs"/>.</summary>
    public string? Manager { get; set; }

    /// <summary>Whether it is on at a time: from its beginning to before its end.</summary>
    /// <param name="time">By the clock of the run.</param>
    public readonly bool IsOn(TimeSpan time) => time >= At && time - At < Duration;
}
