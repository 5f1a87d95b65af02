using System;
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

    // Ctrl-C must end all within a second.
    private static readonly TimeSpan StopTimeout = TimeSpan.FromMilliseconds(300);

    // Longer than any battery of the simulation lasts: no run may hang.
    private static readonly TimeSpan MaxSimulation = TimeSpan.FromMinutes(40);

    public static int Run(ConsoleOptions options)
    {
        Flight? flight = null;
        RunFiles? files = null;
        try
        {
            flight = Flight.Open(options);
            files = RunFiles.Open(options);
        }
        catch (Exception e) when (e is LinkException or ArgumentException or PlatformNotSupportedException)
        {
            flight?.Dispose();
            Console.Error.WriteLine("UavConsole: " + FirstLine(e.Message));
            return BadInput;
        }

        using (flight)
        using (files)
            return Fly(flight, files, options);
    }

    private static int Fly(Flight flight, RunFiles files, ConsoleOptions options)
    {
        // The reactor takes the first Ctrl-C while it runs. Neither a second one nor one that comes late may cut the
        // summary off.
        Console.CancelKeyPress += (_, e) => e.Cancel = true;
        var log = new RunLog(files.Log);
        FlightSummary summary = Show(flight, log, options);
        SummaryText.Write(Console.Out, summary);
        try
        {
            WriteFiles(files, summary);
        }
        catch (ArgumentException e)
        {
            Console.Error.WriteLine("UavConsole: " + FirstLine(e.Message));
            return BadInput;
        }

        if (log.Failure is not { } failure)
            return summary.ExitCode;
        Console.Error.WriteLine("UavConsole: " + FirstLine(failure));
        return BadInput;
    }

    private static FlightSummary Show(Flight flight, RunLog log, ConsoleOptions options)
    {
        RabitReactor reactor = flight.CreateReactor(new ReactorOptions { StopTimeout = StopTimeout, Log = log.Add });
        var recorder = new FlightRecorderManager(new FlightRecorderOptions
        {
            ManagerNames = reactor.Select(m => m.Name).ToArray(),
            StopsWhenMissionEnds = options.FliesMission,
            MaxMissionTime = options.IsSimulated ? MaxSimulation : null,
            ImageChips = () => flight.Uav.ImageProcessing.ImageChips,
        });
        reactor.Add(recorder);
        var monitor = new FlightMonitor(reactor, recorder, flight.Uav.LinkCount);
        Console.WriteLine(flight.Source);
        if (flight.Notice is not null)
            Console.WriteLine(flight.Notice);

        Task<ReactorResult> run = reactor.RunAsync();
        if (options.IsHeadless)
            new PlainLines(monitor, log, options.FliesMission).ShowUntilEnd(run);
        else
            new LiveScreen(monitor, log, options.FliesMission, flight.Notice).ShowUntilEnd(run);
        ReactorResult result = run.GetAwaiter().GetResult();
        monitor.Refresh();
        return Summarise(flight, monitor, result, log, options);
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

    private static void WriteFiles(RunFiles files, FlightSummary summary)
    {
        if (files.Summary is not null)
        {
            using var json = new MemoryStream();
            SummaryJson.Write(json, summary);
            files.Summary.Write(json.ToArray());
        }

        if (files.Report is null)
            return;
        using var page = new StringWriter();
        HtmlReport.Write(page, summary);
        files.Report.Write(Encoding.UTF8.GetBytes(page.ToString()));
        Console.WriteLine("report: " + Path.GetFullPath(files.Report.Path));
    }

    // ArgumentException adds the parameter's name on a line or in brackets; a person needs the sentence alone.
    private static string FirstLine(string text)
    {
        int end = text.IndexOf(" (Parameter '", StringComparison.Ordinal);
        if (end < 0)
            end = text.IndexOfAny(['\r', '\n']);
        return end < 0 ? text : text.Substring(0, end);
    }
}
