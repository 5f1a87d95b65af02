using System.Collections.Generic;

namespace UavConsole;

/// <summary>All that the page tells. Immutable.</summary>
internal sealed class ReportData
{
    /// <summary>As it was given.</summary>
    public string CommandLine { get; init; } = string.Empty;

    /// <summary>Of the simulated world; null on a real link.</summary>
    public long? Seed { get; init; }

    /// <summary>What was flown or listened to, for people.</summary>
    public string Source { get; init; } = string.Empty;

    public FlightRecord Record { get; init; } = FlightRecord.Empty;

    /// <summary>Null where no mission was flown.</summary>
    public MissionOutcome? Outcome { get; init; }

    /// <summary>Oldest first.</summary>
    public IReadOnlyList<FlightEvent> Events { get; init; } = [];

    /// <summary>How many there were in all.</summary>
    public long EventCount { get; init; }

    public IReadOnlyList<ManagerFigures> Managers { get; init; } = [];

    public IReadOnlyList<ImageChipPng> ImageChips { get; init; } = [];

    /// <summary>Why the run ended.</summary>
    public string StopReason { get; init; } = string.Empty;
}
