using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core;
using Rabit.Uav.Reporting;
using Rabit.Uav.Simulation;

namespace UavConsole;

/// <summary>Flies a simulated group, shows it, and reports at the end.</summary>
internal static class GroupRun
{
    private const int BadInput = 2;

    // Longer than any battery of the simulation lasts: no run may hang.
    private static readonly TimeSpan MaxSimulation = TimeSpan.FromMinutes(40);

    // After the last mission the managers still post their last state.
    private static readonly TimeSpan Linger = TimeSpan.FromSeconds(3);

    private static readonly TimeSpan RefreshPeriod = TimeSpan.FromMilliseconds(150);

    /// <inheritdoc cref="FlightRun.Run"/>
    public static int Run(ConsoleOptions options, TextWriter errors)
    {
        GroupFlight? flight = null;
        RunFiles? files = null;
        try
        {
            files = RunFiles.Open(options, Flight.ReadSimulatedMission(options).Plan.Name);
            flight = GroupFlight.Open(options, files.Log);
        }
        catch (ArgumentException e)
        {
            files?.Dispose();
            FaultLine.Write(errors, e.Message);
            return BadInput;
        }

        using (files)
        using (flight)
            return Fly(flight, files, options, errors);
    }

    private static int Fly(GroupFlight flight, RunFiles files, ConsoleOptions options, TextWriter errors)
    {
        using var stop = new StopSignal();

        // A second Ctrl-C, or one that comes late, does not cut the summary off.
        Console.CancelKeyPress += (_, e) => e.Cancel = e.SpecialKey == ConsoleSpecialKey.ControlC;
        var output = GuardedWriter.Create();
        Console.SetOut(output);
        Console.WriteLine(
            $"simulated flight: {flight.Mission.Name}, seed {FlightText.Number(options.Seed)}, "
                + $"{FlightText.Number(options.TargetCount)} targets, "
                + (options.MovingCount == 0
                    ? string.Empty
                    : $"{FlightText.Number(options.MovingCount)} of them moving, ")
                + $"{FlightText.Number(options.Vehicles)} vehicles");
        Task<bool> run = Task.Factory.StartNew(
            () => RunToEnd(flight, options.IsRealTime, stop.Token), CancellationToken.None,
            TaskCreationOptions.LongRunning, TaskScheduler.Default);
        var clock = Stopwatch.StartNew();
        OperatorKeys? keys = options.IsHeadless || !KeyReader.IsPossible
            ? null
            : new OperatorKeys(new GroupKeys(flight.Station.Station), () => stop.Request("key q"));
        if (keys is not null)
            KeyReader.Start(keys, clock);
        string? lost = Show(run, flight, keys, clock, options);
        keys?.Close();
        bool isOver = run.GetAwaiter().GetResult();
        flight.Group.Finish(stop.Reason ?? (isOver ? "the missions are over" : "the missions take too long"));
        foreach (GroupVehicle vehicle in flight.Vehicles)
            vehicle.Refresh();
        FlightSummary[] summaries = flight.Vehicles.Select(v => Summarise(flight, v, options)).ToArray();
        GroupFlightSummary summary = GroupSummary.Of(
            flight, summaries, options, files.Reports.Skip(1).Select(r => r.Path).ToArray(),
            isOver ? null : stop.Reason ?? $"{FlightText.Number(MaxSimulation.TotalMinutes, "0")} min are over");
        GroupSummaryText.Write(Console.Out, summary);
        string?[] losses =
        [
            .. WriteReports(files, summary), files.Log?.Loss, lost, output.Loss,
            .. stop.Reason is null ? NotGiven(flight) : [], .. NotAnswered(flight),
        ];
        foreach (string loss in losses.OfType<string>())
            FaultLine.Write(errors, loss);
        return losses.Any(l => l is not null) ? BadInput : summary.HasPassed ? 0 : 1;
    }

    // On a thread of its own. Whether all missions are over.
    private static bool RunToEnd(GroupFlight flight, bool isRealTime, CancellationToken stop)
    {
        var clock = Stopwatch.StartNew();
        SimulatedGroup group = flight.Group;
        TimeSpan? over = null;
        while (!stop.IsCancellationRequested && group.Now < MaxSimulation)
        {
            flight.Station.Update(group.Now);
            group.Step();
            flight.SampleRadio();
            if (isRealTime && group.Now - clock.Elapsed is { } ahead && ahead > TimeSpan.Zero)
                stop.WaitHandle.WaitOne(ahead);
            bool isOver = flight.Vehicles.All(v => v.FetchIsOver());
            over = isOver ? over ?? group.Now : null;
            if (group.Now - over >= Linger)
                break;
        }

        return over is not null;
    }

    // A terminal that has closed ends the view, not the flight.
    private static string? Show(
        Task run, GroupFlight flight, OperatorKeys? keys, Stopwatch clock, ConsoleOptions options)
    {
        try
        {
            if (options.IsHeadless)
                new GroupLines(flight).ShowUntilEnd(run);
            else
                new GroupScreen(flight, keys, () => keys?.Update(clock.Elapsed)).ShowUntilEnd(run);
            return null;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ObjectDisposedException)
        {
            while (!run.Wait(RefreshPeriod))
                flight.Vehicles.ForEach(v => v.Refresh());
            return "the screen was lost in the flight: " + e.Message;
        }
    }

    private static FlightSummary Summarise(GroupFlight flight, GroupVehicle vehicle, ConsoleOptions options)
    {
        FlightRecord record = vehicle.Monitor.Record;
        SimulatedWorld world = vehicle.Simulated.World;
        MissionScore score = TargetScoring.Score(
            flight.Truth, record, world.PositionOf(world.Truth.Pose.Position with { Down = 0 }));
        ReactorResult result = vehicle.Simulated.Result!;
        return new FlightSummary(record, result)
        {
            Source = $"vehicle {FlightText.Number(vehicle.Simulated.SystemId)} of "
                + $"{FlightText.Number(flight.Vehicles.Count)}: {flight.Mission.Name}, seed "
                + FlightText.Number(options.Seed),
            CommandLine = options.CommandLine,
            Seed = options.Seed,
            OperatorName = options.Reporting.OperatorName,
            MissionFile = flight.MissionFile.Name,
            MissionFileSha256 = flight.MissionFile.Sha256,
            Health = vehicle.Monitor.Health,
            Links = vehicle.Uav.Communications.SummariseLinks(),
            LinkStatus = vehicle.Monitor.Links,
            OwnFrames = vehicle.Uav.Communications.CountOwnFrames(),
            Managers = result.Managers
                .Select((m, index) => new ManagerSummary(m, vehicle.Monitor.UnitOfWorkTimeOf(index))).ToArray(),
            Mission = new MissionSummary(record, score),
            Events = vehicle.Log.Flight.ToArray(),
            EventCount = vehicle.Log.Flight.Count,
        };
    }

    private static IEnumerable<string> NotGiven(GroupFlight flight) => flight.Station.NotGiven.Select(
        c => $"--command {c.Text} was not given: the flight was over after "
            + $"{FlightText.Number(flight.Group.Now.TotalSeconds, "0")} s.");

    private static IEnumerable<string> NotAnswered(GroupFlight flight) => flight.Station.NotAnswered.Select(
        c => $"--command {c.Script.Text} was obeyed by no vehicle: {c.Answer}.");

    private static IEnumerable<string?> WriteReports(RunFiles files, GroupFlightSummary summary)
    {
        if (files.Report is null)
            yield break;
        using var page = new StringWriter();
        GroupHtmlReport.Write(page, summary);
        yield return Write(files.Report, page, "report of the group");
        for (int i = 0; i + 1 < files.Reports.Count; i++)
        {
            using var own = new StringWriter();
            HtmlReport.Write(own, summary.Vehicles[i].Flight);
            yield return Write(files.Reports[i + 1], own, "report");
        }
    }

    private static string? Write(WholeFile file, StringWriter page, string name)
    {
        string? failure = file.Write(Encoding.UTF8.GetBytes(page.ToString()));
        if (failure is null)
            Console.WriteLine(name + ": " + Path.GetFullPath(file.Path));
        return failure;
    }
}
