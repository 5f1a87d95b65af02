using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading.Tasks;
using Rabit.Core;
using Rabit.Links;
using Rabit.Uav.Reporting;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>The main job: opens the flight, runs its managers, shows them, and reports at the end.</summary>
internal static class FlightRun
{
    private const int BadInput = 2;

    // Ctrl-C ends all within a fraction of that. On Mono and a busy machine a socket was seen to take 0.4 s to close.
    private static readonly TimeSpan StopTimeout = TimeSpan.FromSeconds(1);

    // Failsafes and fence of the autopilot are written back in less, on a link that loses a few frames.
    private static readonly TimeSpan MaxStopDelay = TimeSpan.FromSeconds(10);

    private static readonly TimeSpan RefreshPeriod = TimeSpan.FromMilliseconds(200);

    // Longer than any battery of the simulation lasts: no run may hang.
    private static readonly TimeSpan MaxSimulation = TimeSpan.FromMinutes(40);

    /// <param name="options">What was asked for.</param>
    /// <param name="errors">Where a fault is written: one line each.</param>
    /// <returns>The exit code.</returns>
    public static int Run(ConsoleOptions options, TextWriter errors)
    {
        if (options.AbandonedStateFile is not null)
            return AbandonedRun.Run(options, errors);
        if (options.Vehicles > 1)
            return GroupRun.Run(options, errors);
        Flight? flight = null;
        RunFiles? files = null;
        WebView? web = null;
        try
        {
            flight = Flight.Open(options);
            files = RunFiles.Open(options, flight.MissionName);
            web = WebView.Open(options.Web);
            options.Operator.KeepEarlierProgress();
        }
        catch (Exception e) when (e is LinkException or ArgumentException or PlatformNotSupportedException)
        {
            web?.Dispose();
            flight?.Dispose();
            FaultLine.Write(errors, e.Message);
            return BadInput;
        }

        using (flight)
        using (files)
        using (web)
            return Fly(flight, files, web, options, errors);
    }

    private static int Fly(Flight flight, RunFiles files, WebView? web, ConsoleOptions options, TextWriter errors)
    {
        // The reactor takes the first Ctrl-C while it runs. Neither a second one nor one that comes late may cut the
        // summary off. Ctrl-\ keeps its meaning.
        Console.CancelKeyPress += (_, e) => e.Cancel = e.SpecialKey == ConsoleSpecialKey.ControlC;
        var output = GuardedWriter.Create();
        Console.SetOut(output);
        var log = new RunLog(files.Log);
        FlightSummary summary = Show(flight, log, web, options);
        SummaryText.Write(Console.Out, summary);
        string?[] losses =
        [
            WriteSummary(files, summary), WriteReport(files, summary), ReportRecording(flight),
            ReportKeptPictures(flight, options),
            .. files.Exports.Select(file => WriteExport(file, summary)), log.Loss, log.ViewLoss, output.Loss,
        ];
        foreach (string? loss in losses)
        {
            if (loss is not null)
                FaultLine.Write(errors, loss);
        }

        return losses.Any(l => l is not null) ? BadInput : summary.ExitCode;
    }

    // Whatever else is lost, each file that can be written is complete.
    private static string? WriteSummary(RunFiles files, FlightSummary summary)
    {
        using var json = new MemoryStream();
        SummaryJson.Write(json, summary);
        return files.Summary?.Write(json.ToArray());
    }

    private static string? WriteReport(RunFiles files, FlightSummary summary)
    {
        if (files.Report is null)
            return null;
        using var page = new StringWriter();
        HtmlReport.Write(page, summary);
        string? failure = files.Report.Write(Encoding.UTF8.GetBytes(page.ToString()));
        if (failure is null)
            Console.WriteLine("report: " + Path.GetFullPath(files.Report.Path));
        return failure;
    }

    private static string? ReportKeptPictures(Flight flight, ConsoleOptions options)
    {
        if (options.KeptPictures is not { } kept
            || flight.Uav.ImageProcessing.SummariseKeptPictures() is not { } counts)
            return null;
        Console.WriteLine($"kept pictures: {FlightText.Number(counts.Kept)} in {Path.GetFullPath(kept.Folder)}");
        return counts.NotKept == 0
            ? null
            : $"{FlightText.Number(counts.NotKept)} pictures were not kept: {counts.LastFault ?? "no room to wait"}.";
    }

    private static string? ReportRecording(Flight flight)
    {
        if (flight.Uav.Communications.SummariseRecording() is not { } recording)
            return null;
        if (recording.File is { } file)
        {
            string last = recording.Files == 1 ? string.Empty : $", the last of {FlightText.Number(recording.Files)}";
            Console.WriteLine(
                $"tlog: {Path.GetFullPath(file)} ({FlightText.Number(recording.Frames)} frames{last})");
        }

        long missing = recording.FramesDropped + recording.FramesLost;
        return missing == 0
            ? null
            : $"the recording misses {FlightText.Number(missing)} frames: {FlightText.Number(recording.FramesLost)} "
                + $"could not be written{(recording.Fault is { } fault ? $" ({fault.TrimEnd('.')})" : string.Empty)}, "
                + $"{FlightText.Number(recording.FramesDropped)} had no room to wait for the disk.";
    }

    private static string? WriteExport(WholeFile file, FlightSummary summary)
    {
        using var content = new MemoryStream();
        ExportFormat.Find(file.Path)!(content, summary);
        return file.Write(content.ToArray());
    }

    private static FlightSummary Show(Flight flight, RunLog log, WebView? web, ConsoleOptions options)
    {
        RabitReactor reactor = flight.CreateReactor(
            new ReactorOptions
            {
                StopTimeout = StopTimeout,
                MaxStopDelay = MaxStopDelay,
                Log = entry =>
                {
                    log.Add(entry);
                    web?.Log(entry);
                },
            });
        var recorder = new FlightRecorderManager(new FlightRecorderOptions
        {
            ManagerNames = reactor.Select(m => m.Name).ToArray(),
            StopsWhenMissionEnds = options.FliesMission,
            MaxMissionTime = options.IsSimulated ? MaxSimulation : null,
            ImageChips = () => flight.Uav.ImageProcessing.ImageChips,
            FindPictureOverview = number => flight.Uav.ImageProcessing.FindPictureOverview(number),
        });
        reactor.Add(recorder);
        web?.Add(reactor, flight, options.FliesMission);
        var fixedWing = new FixedWingNotice(options.Operator, text => log.Note(reactor.Now, text));
        var clock = Stopwatch.StartNew();
        OperatorKeys? keys = options.IsHeadless || !KeyReader.IsPossible
            ? null
            : new OperatorKeys(
                options.FliesMission ? new MissionKeys(flight.Uav.MissionControl) : null, () => reactor.Stop("key q"));
        Bell? bell = options.Operator.HasBell && !Console.IsOutputRedirected
            ? new Bell(() => Console.Write('\a'))
            : null;
        var monitor = new FlightMonitor(reactor, recorder, flight.Uav.LinkCount)
        {
            Refreshed = (record, health) =>
            {
                options.Operator.Update(record.Mission.Phase, flight.Uav.MissionControl);
                fixedWing.Check(record.Vehicle);
                keys?.Update(clock.Elapsed);
                bell?.Update(record.Mission, health.Advice);
            },
        };
        Console.WriteLine(flight.Source);
        if (flight.Notice is not null)
            Console.WriteLine(flight.Notice);
        using IDisposable diagnostics = RunDiagnostics.Open(reactor, log);
        Task<ReactorResult> run = reactor.RunAsync();

        // Now that signals stop the flight in order: who has waited for this line may send one.
        if (web is not null)
            Console.WriteLine("live page: " + web.Address);
        if (keys is not null)
            KeyReader.Start(keys, clock);
        ShowUntilEnd(run, flight, monitor, log, options, keys);
        keys?.Close();
        ReactorResult result = run.GetAwaiter().GetResult();
        monitor.Refresh();
        return Summarise(flight, monitor, result, log, options);
    }

    // A terminal that has closed ends the view, not the flight: a vehicle in the air is to be held first.
    private static void ShowUntilEnd(
        Task run, Flight flight, FlightMonitor monitor, RunLog log, ConsoleOptions options, IKeyHints? keys)
    {
        try
        {
            if (options.IsHeadless)
                new PlainLines(monitor, log, options.FliesMission).ShowUntilEnd(run);
            else
                new LiveScreen(monitor, log, options.FliesMission, flight.Notice, keys).ShowUntilEnd(run);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ObjectDisposedException)
        {
            log.NoteViewLost(e.Message);
            while (!run.Wait(RefreshPeriod))
                monitor.Refresh();
        }
    }

    private static FlightSummary Summarise(
        Flight flight, FlightMonitor monitor, ReactorResult result, RunLog log, ConsoleOptions options)
    {
        FlightRecord record = monitor.Record;
        MissionScore? score = flight.Truth is null
            ? null
            : TargetScoring.Score(flight.Truth, record, flight.TruePosition());
        return new FlightSummary(record, result)
        {
            Source = flight.Source,
            CommandLine = options.CommandLine,
            Seed = options.IsSimulated ? options.Seed : null,
            StartTime = StartOf(record, options),
            OperatorName = options.Reporting.OperatorName,
            MissionFile = flight.MissionFile?.Name ?? string.Empty,
            MissionFileSha256 = flight.MissionFile?.Sha256 ?? string.Empty,
            Health = monitor.Health,
            Links = flight.Uav.Communications.SummariseLinks(),
            LinkStatus = monitor.Links,
            OwnFrames = flight.Uav.Communications.CountOwnFrames(),
            Camera = flight.Camera is null ? null : new CameraSummary(flight.Camera),
            Managers = result.Managers.Select((m, index) => new ManagerSummary(m, monitor.UnitOfWorkTimeOf(index)))
                .ToArray(),
            Mission = options.FliesMission ? new MissionSummary(record, score) : null,
            Events = log.Flight.ToArray(),
            EventCount = log.Flight.Count,
        };
    }

    // The frames of a live link have the time of our clock, those of a log that of its records.
    private static DateTimeOffset? StartOf(FlightRecord record, ConsoleOptions options)
    {
        if (options.IsSimulated || record.Telemetry.FirstUtcMicroseconds is not { } first)
            return null;
        DateTimeOffset utc = new DateTimeOffset(1970, 1, 1, 0, 0, 0, TimeSpan.Zero).AddTicks(first * 10);
        return options.IsReplay ? utc : utc.ToLocalTime();
    }
}
