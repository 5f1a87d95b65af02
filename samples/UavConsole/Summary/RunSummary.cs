using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.AutopilotInterface;
using Rabit.Uav.Communications;
using Rabit.Uav.ImageProcessing;
using Rabit.Uav.Messages;
using Rabit.Vision;

namespace UavConsole;

/// <summary>All that is told at the end of a run, gathered from where it was counted.</summary>
internal sealed class RunSummary
{
    /// <param name="source">What was run.</param>
    /// <param name="monitor">Refreshed after the end.</param>
    /// <param name="result">How it ended.</param>
    /// <param name="options">As it was asked for.</param>
    public RunSummary(Flight source, FlightMonitor monitor, ReactorResult result, ConsoleOptions options)
    {
        Flight = source.Uav.Autopilot.Flight;
        Links = source.Uav.Communications.SummariseLinks();
        LinkStatus = monitor.Links;
        OwnFrames = source.Uav.Communications.CountOwnFrames();
        Camera = source.Camera;
        Health = monitor.Health;
        Record = monitor.Record;
        Result = result;
        Source = source.Source;
        Options = options;
        Managers = result.Managers.Select((m, index) => Figures(m, monitor.UnitOfWorkTimeOf(index))).ToArray();
        Outcome = options.FliesMission ? MissionJudge.Judge(Record, source.Truth, source.TruePosition()) : null;
        HasReplayLostFrames = LinkStatus.Any(l => !double.IsNaN(l.Progress) && (l.FramesDroppedIn > 0 || l.State == LinkState.Failed));
    }

    public FlightSummary Flight { get; }

    public IReadOnlyList<LinkSummary> Links { get; }

    /// <summary>As last told by Communications; in the order of <see cref="Links"/>.</summary>
    public IReadOnlyList<LinkStatus> LinkStatus { get; }

    /// <summary>Frames of our own, counted apart from what came in.</summary>
    public IReadOnlyList<FrameCount> OwnFrames { get; }

    /// <summary>The folder of pictures; null where there is none.</summary>
    public FolderCamera? Camera { get; }

    public HealthReport Health { get; }

    /// <summary>What the recorder kept.</summary>
    public FlightRecord Record { get; }

    public ReactorResult Result { get; }

    /// <summary>With the time that their work took.</summary>
    public IReadOnlyList<ManagerFigures> Managers { get; }

    /// <summary>Null where no mission was flown.</summary>
    public MissionOutcome? Outcome { get; }

    /// <summary>What was run, for people.</summary>
    public string Source { get; }

    public ConsoleOptions Options { get; }

    /// <summary>A replay that lost a frame has failed: it would not show the flight as it was.</summary>
    public bool HasReplayLostFrames { get; }

    public int ExitCode => HasReplayLostFrames || Outcome is { HasPassed: false } ? 1 : Result.ExitCode;

    public ReportData ToReport(EventLog log)
    {
        (IReadOnlyList<FlightEvent> events, long count) = log.TakeAll();
        return new ReportData
        {
            CommandLine = Options.CommandLine,
            Seed = Options.IsSimulated ? Options.Seed : null,
            Source = Source,
            Record = Record,
            Outcome = Outcome,
            Events = events,
            EventCount = count,
            Managers = Managers,
            ImageChips = Record.Pictures.Select(c => new ImageChipPng(c.PictureNumber, c.ReportIndex, new RgbPicture(c.Width, c.Height, c.CopyPixels()))).ToArray(),
            StopReason = Result.StopReason,
        };
    }

    private static ManagerFigures Figures(ManagerResult manager, in DurationStatistics work) => new()
    {
        Name = manager.Name,
        Outcome = manager.Outcome.ToString(),
        Runs = manager.Runs,
        Faults = manager.FaultCount,
        FirstFault = manager.Faults.Count == 0 ? null : manager.Faults[0].ToString(),
        MeanWork = work.Mean,
        LongestWork = work.Max,
        TotalWork = work.Total,
    };
}
