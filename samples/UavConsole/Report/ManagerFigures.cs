using System;

namespace UavConsole;

/// <summary>What one manager did in a run. Immutable.</summary>
internal sealed class ManagerFigures
{
    public string Name { get; init; } = string.Empty;

    /// <summary>How it ended.</summary>
    public string Outcome { get; init; } = string.Empty;

    /// <summary>Units of work.</summary>
    public long Runs { get; init; }

    public long Faults { get; init; }

    /// <summary>The first one, for people; null where there was none.</summary>
    public string? FirstFault { get; init; }

    /// <summary>Of the units of work, in real time.</summary>
    public TimeSpan MeanWork { get; init; }

    /// <summary>Of the units of work, in real time.</summary>
    public TimeSpan LongestWork { get; init; }

    /// <summary>Of the units of work, in real time.</summary>
    public TimeSpan TotalWork { get; init; }
}
