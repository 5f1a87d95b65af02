using System;
using System.Linq;
using System.Text;
using System.Threading.Tasks;
using Rabit.Core;
using Rabit.Links;

namespace UavConsole;

/// <summary>The main job: opens the flight, runs its managers, shows them, and tells at the end what there was.</summary>
internal static class FlightRun
{
    private const int BadInput = 2;

    // Ctrl-C must end all within a second.
    private static readonly TimeSpan StopTimeout = TimeSpan.FromMilliseconds(300);

    // Longer than any battery of the simulation lasts: nothing may hang.
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
        // The reactor takes the first Ctrl-C while it runs. Neither a second one nor one that comes late may cut the summary off.
        Console.CancelKeyPress += (_, e) => e.Cancel = true;
        var events = new EventLog(files.Log);
        RunSummary summary = Show(flight, events, options);
        new SummaryText(Console.Out, summary).Write();
        try
        {
            WriteFiles(files, summary, events);
        }
        catch (ArgumentException e)
        {
            Console.Error.WriteLine("UavConsole: " + FirstLine(e.Message));
            return BadInput;
        }

        if (events.Failure is not { } failure)
            return summary.ExitCode;
        Console.Error.WriteLine("UavConsole: " + FirstLine(failure));
        return BadInput;
    }

    private static RunSummary Show(Flight flight, EventLog events, ConsoleOptions options)
    {
        var log = new RunLog();
        RabitReactor reactor = flight.CreateReactor(new ReactorOptions
        {
            StopTimeout = StopTimeout,
            Log = entry =>
            {
                log.Add(entry);
                events.Add(entry);
            },
        });
        var recorder = new MissionRecorder(reactor.Select(m => m.Name).ToList(), new RecorderOptions
        {
            StopsWhenMissionEnds = options.FliesMission,
            MaxMission = options.IsSimulated ? MaxSimulation : null,
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
        return new RunSummary(flight, monitor, result, options);
    }

    private static void WriteFiles(RunFiles files, RunSummary summary, EventLog events)
    {
        files.Summary?.Write(SummaryJson.Write(summary));
        if (files.Report is null)
            return;
        files.Report.Write(Encoding.UTF8.GetBytes(MissionReport.Write(summary.ToReport(events))));
        Console.WriteLine("report: " + System.IO.Path.GetFullPath(files.Report.Path));
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
