using System.Collections.Immutable;
using System.Linq;

namespace Rabit.Uav.Messages;

/// <summary>
/// The pre-flight checklist: posted by Health Monitoring when a line changes, until the motors run. Immutable.
/// </summary>
public sealed class PreflightReport
{
    /// <summary>Nothing is checked yet.</summary>
    public static PreflightReport None { get; } = new();

    /// <summary>Whether all that is checked has been asked for: before that the lines may still change.</summary>
    public bool IsComplete { get; init; }

    /// <summary>The lines, those of the vehicle first; empty where the autopilot is not known yet.</summary>
    public ImmutableArray<PreflightLine> Lines { get; init; } = [];

    /// <summary>
    /// What the vehicle does when this computer fails in flight, by its parameters, as text; empty while it is not
    /// known.
    /// </summary>
    public string WhenComputerFails { get; init; } = string.Empty;

    /// <summary>Whether the flight may begin.</summary>
    public bool Passes => IsComplete && Lines.Length > 0 && !Lines.Any(l => l.Refuses);

    /// <summary>Why the flight may not begin, as one line of text; null where it may.</summary>
    public string? FindRefusal()
    {
        if (Passes)
            return null;
        PreflightLine[] refusals = Lines.Where(l => l.Refuses).ToArray();
        return !IsComplete || refusals.Length == 0
            ? "pre-flight checklist: the parameters of the autopilot are being read"
            : "pre-flight checklist: " + string.Join(", ", refusals.Select(l => $"{l.Name} ({l.Value})"));
    }
}
