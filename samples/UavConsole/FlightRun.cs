using System;
using System.Linq;
using System.Threading.Tasks;
using Rabit.Core;
using Rabit.Uav;
using Rabit.Uav.Links;

namespace UavConsole;

/// <summary>The main job: opens the UAV, runs its managers, shows them, and tells at the end what there was.</summary>
internal static class FlightRun
{
    private const int BadInput = 2;

    // Ctrl-C must end all within a second.
    private static readonly TimeSpan StopTimeout = TimeSpan.FromMilliseconds(300);

    public static int Run(ConsoleOptions options)
    {
        UavSystem? uav = null;
        SummaryFile? summaryFile = null;
        try
        {
            uav = UavSystem.Open(new UavOptions { Links = options.Links, SystemId = options.SystemId });
            summaryFile = SummaryFile.Open(options);
        }
        catch (Exception e) when (e is LinkException or ArgumentException or PlatformNotSupportedException)
        {
            uav?.Dispose();
            Console.Error.WriteLine("UavConsole: " + FirstLine(e));
            return BadInput;
        }

        using (uav)
        using (summaryFile)
            return Fly(uav, summaryFile, options);
    }

    private static int Fly(UavSystem uav, SummaryFile? summaryFile, ConsoleOptions options)
    {
        // The reactor takes the first Ctrl-C while it runs. Neither a second one nor one that comes late may cut the summary off.
        Console.CancelKeyPress += (_, e) => e.Cancel = true;
        RunSummary summary = Show(uav, options);
        new SummaryText(Console.Out, summary).Write();
        try
        {
            summaryFile?.Write(summary);
        }
        catch (ArgumentException e)
        {
            Console.Error.WriteLine("UavConsole: " + FirstLine(e));
            return BadInput;
        }

        return summary.ExitCode;
    }

    private static RunSummary Show(UavSystem uav, ConsoleOptions options)
    {
        var log = new RunLog();
        RabitReactor reactor = uav.CreateReactor(new ReactorOptions { Log = log.Add, StopTimeout = StopTimeout });
        var monitor = new FlightMonitor(reactor, uav);
        Console.WriteLine("replaying or listening to " + string.Join(", ", options.Links.Select(l => l.ToString())));

        Task<ReactorResult> run = reactor.RunAsync();
        if (options.IsHeadless)
            new PlainLines(monitor, log).ShowUntilEnd(run);
        else
            new LiveScreen(monitor, log).ShowUntilEnd(run);
        ReactorResult result = run.GetAwaiter().GetResult();
        monitor.Refresh();
        return new RunSummary(uav, result, monitor.Health, monitor.Links);
    }

    // ArgumentException adds the parameter's name on a line or in brackets; a person needs the sentence alone.
    private static string FirstLine(Exception e)
    {
        string text = e.Message;
        int end = text.IndexOf(" (Parameter '", StringComparison.Ordinal);
        if (end < 0)
            end = text.IndexOfAny(['\r', '\n']);
        return end < 0 ? text : text.Substring(0, end);
    }
}
