using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Communications;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>
/// Everything that is reported at the end of a run, for <see cref="SummaryText"/>, <see cref="SummaryJson"/> and
/// <see cref="HtmlReport"/>. Immutable. Only the record and the result are needed; what is not set is left out.
/// </summary>
/// <example>
/// <code>
/// ReactorResult result = reactor.Run();
/// var summary = new FlightSummary(recorder.Record, result)
/// {
///     Source = "search over udpin:0.0.0.0:14550",
///     Links = uav.Communications.SummariseLinks(),
///     OwnFrames = uav.Communications.CountOwnFrames(),
///     Mission = new MissionSummary(recorder.Record, score: null),
/// };
/// SummaryText.Write(Console.Out, summary);
/// </code>
/// </example>
public sealed class FlightSummary
{
    private readonly int _runExitCode;

    /// <summary>Makes a summary.</summary>
    /// <param name="record">Taken after the run.</param>
    /// <param name="result">How the run ended.</param>
    public FlightSummary(FlightRecord record, ReactorResult result)
        : this(record)
    {
        if (result is null)
            throw new ArgumentNullException(nameof(result));
        StopReason = result.StopReason;
        RunTime = result.Duration;
        _runExitCode = result.ExitCode;
        Managers = result.Managers.Select(m => new ManagerSummary(m, default)).ToArray();
    }

    /// <summary>Makes a summary of a record alone, for example while the run goes on.</summary>
    /// <param name="record">The record.</param>
    public FlightSummary(FlightRecord record)
    {
        Record = record ?? throw new ArgumentNullException(nameof(record));
        Health = record.Health;
    }

    /// <summary>What was recorded.</summary>
    public FlightRecord Record { get; }

    /// <summary>What was flown or observed, for people.</summary>
    public string Source { get; init; } = string.Empty;

    /// <summary>The command line of the program; empty for none.</summary>
    public string CommandLine { get; init; } = string.Empty;

    /// <summary>
    /// When the flight began, by a clock on the wall and with its offset from UTC; null for a simulated one.
    /// </summary>
    public DateTimeOffset? StartTime { get; init; }

    /// <summary>Who was responsible for the flight; empty where that is not known.</summary>
    public string OperatorName { get; init; } = string.Empty;

    /// <summary>The file of the mission; empty for none.</summary>
    public string MissionFile { get; init; } = string.Empty;

    /// <summary>SHA-256 of the mission file, 64 hexadecimal digits; empty for none.</summary>
    public string MissionFileSha256 { get; init; } = string.Empty;

    /// <summary>The seed of a simulated world; null for a real one.</summary>
    public long? Seed { get; init; }

    /// <summary>Why the run ended.</summary>
    public string StopReason { get; init; } = string.Empty;

    /// <summary>Duration of the run, by the clock of the run.</summary>
    public TimeSpan RunTime { get; init; }

    /// <summary>The last health report.</summary>
    public HealthReport Health { get; init; }

    /// <summary>What came in over each link.</summary>
    public IReadOnlyList<LinkSummary> Links { get; init; } = [];

    /// <summary>The last posted status of each link, in the order of <see cref="Links"/>.</summary>
    public IReadOnlyList<LinkStatus> LinkStatus { get; init; } = [];

    /// <summary>Frames that this computer made; they are not counted in <see cref="Links"/>.</summary>
    public IReadOnlyList<FrameCount> OwnFrames { get; init; } = [];

    /// <summary>What the camera folder delivered; null where there is none.</summary>
    public CameraSummary? Camera { get; init; }

    /// <summary>What each manager did.</summary>
    public IReadOnlyList<ManagerSummary> Managers { get; init; } = [];

    /// <summary>The result of the mission; null where none was flown.</summary>
    public MissionSummary? Mission { get; init; }

    /// <summary>Entries of the log, oldest first: <see cref="FlightLog.ToArray"/>.</summary>
    public IReadOnlyList<FlightEvent> Events { get; init; } = [];

    /// <summary>How many entries the log had; those that are not in <see cref="Events"/> included.</summary>
    public long EventCount { get; init; }

    /// <summary>
    /// Whether a replay lost a frame, or could not be read to its end: then it does not show the flight as it was.
    /// </summary>
    public bool HasReplayLostFrames => LinkStatus.Any(l => !double.IsNaN(l.Progress)
        && (l.FramesDroppedIn > 0 || l.State == LinkState.Failed || Record.Telemetry.FramesDropped > 0));

    /// <summary>
    /// The exit code of a program that flew this: 0, or 1 where the mission failed, a manager faulted or a replay
    /// lost a frame.
    /// </summary>
    public int ExitCode => HasReplayLostFrames || Mission is { HasPassed: false } ? 1 : _runExitCode;
}
