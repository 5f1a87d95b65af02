using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Threading.Tasks;
using Rabit.Core;
using Rabit.Uav.Messages;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace UavConsole;

/// <summary>The view for a terminal: managers, vehicle, health, links, texts and a progress bar, a few times a second.</summary>
internal sealed class LiveScreen(FlightMonitor monitor, RunLog log)
{
    private static readonly TimeSpan RefreshEvery = TimeSpan.FromMilliseconds(150);
    private const int TextsShown = 6;
    private const int BarWidth = 60;

    private readonly Queue<string> _notes = new();

    /// <summary>Whether the output is a terminal that can be drawn on.</summary>
    public static bool IsPossible() => !Console.IsOutputRedirected && AnsiConsole.Profile.Capabilities.Ansi && AnsiConsole.Profile.Capabilities.Interactive;

    public void ShowUntilEnd(Task run) => AnsiConsole.Live(Draw()).Overflow(VerticalOverflow.Crop).Start(context =>
    {
        bool hasEnded = false;
        while (!hasEnded)
        {
            hasEnded = run.Wait(RefreshEvery);
            monitor.Refresh();
            context.UpdateTarget(Draw());
        }
    });

    internal Rows Draw()
    {
        var rows = new List<IRenderable> { Managers(), Vehicle(), Links(), Texts() };
        if (monitor.Progress is { } progress)
            rows.Add(new Markup(Bar(progress)));
        return new Rows(rows);
    }

    private Table Managers()
    {
        Table table = new Table().Border(TableBorder.Rounded).Title("[bold]managers[/]");
        table.AddColumns("manager", "state");
        table.AddColumn(new TableColumn("runs").RightAligned());
        table.AddColumn("woken by");
        foreach (string column in new[] { "merged", "work ms mean/max", "wake ms mean/max", "faults" })
            table.AddColumn(new TableColumn(column).RightAligned());
        for (int index = 0; index < monitor.Managers.Count; index++)
            AddManager(table, index);
        return table;
    }

    private void AddManager(Table table, int index)
    {
        ManagerStatus status = monitor.Managers[index];
        DurationStatistics work = monitor.UnitOfWorkTimeOf(index);
        WakeUpCounts wakes = status.WakeUps;
        table.AddRow(
            monitor.ManagerNames[index],
            status.State == ManagerState.Faulted ? "[red]Faulted[/]" : status.State.ToString(),
            Number(status.Runs),
            Causes(wakes),
            Number(wakes.Merged),
            $"{Text.Milliseconds(work.Mean)}/{Text.Milliseconds(work.Maximum)}",
            $"{Text.Milliseconds(status.WakeLatency.Mean)}/{Text.Milliseconds(status.WakeLatency.Maximum)}",
            status.Faults == 0 ? "0" : $"[red]{Number(status.Faults)}[/]");
    }

    private static string Causes(in WakeUpCounts wakes)
    {
        (string Name, long Count)[] causes =
        [
            ("timer", wakes.Timer), ("post", wakes.Post), ("push", wakes.Push), ("pop", wakes.Pop), ("request", wakes.Request), ("device", wakes.Device),
        ];
        return string.Join(" ", causes.Where(c => c.Count > 0).Select(c => $"{c.Name} {Number(c.Count)}"));
    }

    private Table Vehicle()
    {
        VehicleState vehicle = monitor.Vehicle;
        Table table = new Table().Border(TableBorder.Rounded).HideHeaders().AddColumns("what", "value", "what", "value");
        table.AddRow("vehicle", Plain(Text.Vehicle(vehicle)), "mode", Plain(Text.Flight(vehicle)));
        table.AddRow("position", Plain(Text.Position(vehicle)), "velocity", Plain(Text.Velocity(vehicle)));
        table.AddRow("attitude", Plain(Text.Attitude(vehicle)), "battery", Plain(Text.Battery(vehicle)));
        table.AddRow("GPS", Plain(Text.Gps(vehicle)), "health", Health());
        return table;
    }

    private string Health()
    {
        HealthReport health = monitor.Health;
        string colour = health.Level switch
        {
            HealthLevel.Good => "green",
            HealthLevel.Warning => "yellow",
            HealthLevel.Critical => "red",
            _ => "grey",
        };
        return $"[{colour}]{Plain(Text.Health(health))}[/]{(health.SendsHeartbeat ? "" : " [grey](no heartbeat of ours)[/]")}";
    }

    private Table Links()
    {
        Table table = new Table().Border(TableBorder.Rounded).AddColumns("link", "status");
        foreach (LinkStatus link in monitor.Links)
            table.AddRow(Plain(link.Url ?? "-"), Plain(Text.Link(link)));
        return table;
    }

    private Panel Texts()
    {
        foreach (RabitLogEntry entry in log.TakeAll())
            _notes.Enqueue(Plain(entry.ToString()));
        while (_notes.Count > 3)
            _notes.Dequeue();
        IEnumerable<string> texts = monitor.Texts.Take(TextsShown).Reverse().Select(t => Plain(Text.At(t.Time) + Text.Of(t)));
        string[] lines = texts.Concat(_notes.Select(n => $"[grey]{n}[/]")).ToArray();
        return new Panel(new Markup(lines.Length == 0 ? "-" : string.Join("\n", lines))).Header("status texts and log").Expand();
    }

    private static string Bar(double progress)
    {
        int done = (int)Math.Round(progress * BarWidth);
        return string.Format(CultureInfo.InvariantCulture, "[green]{0}[/][grey]{1}[/] {2:0}%", new string('━', done), new string('━', BarWidth - done), progress * 100);
    }

    private static string Number(long value) => value.ToString(CultureInfo.InvariantCulture);

    // What came from outside must not be taken for markup.
    private static string Plain(string text) => Markup.Escape(text);
}
