using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Rabit.Core;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;
using Spectre.Console;
using Spectre.Console.Rendering;

namespace UavConsole;

/// <summary>
/// The screen of a flight that is watched: managers, vehicle, health, links, texts and a progress bar.
/// </summary>
internal sealed class VehicleView(FlightMonitor monitor, string? notice)
{
    private const int TextsShown = 4;
    private const int NotesShown = 2;
    private const int MaxLinkNameLength = 40;
    private const int BarWidth = 60;
    private const int MinWidth = 80;

    // Fits 80 by 24: one row for each manager and link where they are few, and every text on one line.
    public Rows Draw(IEnumerable<string> notes, int width)
    {
        if (width < MinWidth)
            return DrawNarrow(notes, width);
        var rows = new List<IRenderable> { Managers(), Vehicle() };
        rows.AddRange(Links());
        if (notice is not null)
            rows.Add(OneLine(notice, "yellow"));
        rows.AddRange(Texts(notes));
        if (monitor.Progress is { } progress)
            rows.Add(new Markup(Bar(progress)));
        return new Rows(rows);
    }

    // Plain lines, without the table of the managers; what is longer is cut off.
    private Rows DrawNarrow(IEnumerable<string> notes, int width)
    {
        VehicleState vehicle = monitor.Vehicle;
        List<string> lines =
        [
            Text.Vehicle(vehicle), "mode " + Text.Flight(vehicle), "health " + FlightText.Health(monitor.Health),
            "battery " + Text.Battery(vehicle), "GPS " + Text.Gps(vehicle), Text.Position(vehicle),
            .. monitor.Links.Select(l => $"link {ShortName(l.Url)} {Text.Link(l)}"),
            .. monitor.Texts.Take(TextsShown).Reverse().Select(Text.Of),
            .. notes.Reverse().Take(NotesShown).Reverse(),
        ];
        if (notice is not null)
            lines.Insert(0, notice);
        if (monitor.Progress is { } progress)
            lines.Add(FlightText.Number(progress * 100, "0") + " % of the log");
        return new Rows(lines.Select(
            l => new Markup(Plain(Text.Fit(FlightText.Printable(l), width).TrimEnd())).Overflow(Overflow.Crop)));
    }

    private Table Managers()
    {
        Table table = new Table().Border(TableBorder.None).AddColumns("[bold]managers[/]", "state");
        table.AddColumn(new TableColumn("runs").RightAligned());
        table.AddColumn("woken by");
        foreach (string column in new[] { "work ms", "wake ms", "faults" })
            table.AddColumn(new TableColumn(column).RightAligned());
        for (int index = 0; index < monitor.Managers.Count; index++)
            AddManager(table, index);
        return table;
    }

    private void AddManager(Table table, int index)
    {
        ManagerStatus status = monitor.Managers[index];
        DurationStatistics work = monitor.UnitOfWorkTimeOf(index);
        table.AddRow(
            monitor.ManagerNames[index],
            status.State is ManagerState.Faulted or ManagerState.Restarting or ManagerState.Hanging
                ? $"[red]{status.State}[/]"
                : status.State.ToString(),
            Number(status.Runs),
            Causes(status.WakeUps),
            MeanAndMaximum(work),
            MeanAndMaximum(status.WakeLatency),
            status.Faults == 0 ? "0" : $"[red]{Number(status.Faults)}[/]");
    }

    private static string Causes(in WakeUpStatistics wakes)
    {
        (string Name, long Count)[] causes =
        [
            ("timer", wakes.Timer), ("post", wakes.Post), ("push", wakes.Push), ("pop", wakes.Pop),
            ("request", wakes.Request), ("device", wakes.Device), ("merged", wakes.Merged),
        ];
        return string.Join(" ", causes.Where(c => c.Count > 0).Select(c => $"{c.Name} {Number(c.Count)}"));
    }

    private static string MeanAndMaximum(in DurationStatistics time)
        => string.Format(
            CultureInfo.InvariantCulture, "{0:0.00}/{1:0.0}", time.Mean.TotalMilliseconds, time.Max.TotalMilliseconds);

    private Grid Vehicle()
    {
        VehicleState vehicle = monitor.Vehicle;
        Grid grid = new Grid().AddColumn(new GridColumn().NoWrap()).AddColumn();
        grid.AddRow("[bold]vehicle[/]", Plain(Text.Vehicle(vehicle)));
        grid.AddRow("mode", Plain(Text.Flight(vehicle)));
        grid.AddRow("position", Plain(Text.Position(vehicle)));
        grid.AddRow("velocity", Plain(Text.Velocity(vehicle)));
        grid.AddRow("attitude", Plain(Text.Attitude(vehicle)));
        grid.AddRow("battery", Plain($"{Text.Battery(vehicle)}; GPS {Text.Gps(vehicle)}"));
        grid.AddRow("health", Health());
        return grid;
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
        return $"[{colour}]{Plain(FlightText.Health(health))}[/]{(health.SendsHeartbeat ? "" : " [grey](no heartbeat of ours)[/]")}";
    }

    private IEnumerable<IRenderable> Links() => monitor.Links.Select(link => new Markup(
        $"[bold]link[/] {Plain(ShortName(link.Url))} {Plain(Text.Link(link))}"));

    // The end of a long path says more than its beginning.
    private static string ShortName(string? url)
        => url is null ? "-"
            : url.Length <= MaxLinkNameLength ? url
            : $"...{url.Substring(url.Length - MaxLinkNameLength + 3)}";

    private IEnumerable<IRenderable> Texts(IEnumerable<string> notes)
    {
        IEnumerable<string> texts = monitor.Texts.Take(TextsShown).Reverse()
            .Select(t => FlightText.TimeStamp(t.Time) + Text.Of(t));
        string[] last = notes.ToArray();
        return texts.Select(t => OneLine(t, "default"))
            .Concat(last.Skip(last.Length - NotesShown).Select(n => OneLine(n, "grey")));
    }

    private static Markup OneLine(string text, string colour)
        => new Markup($"[{colour}]{Plain(text)}[/]").Overflow(Overflow.Ellipsis);

    private static string Bar(double progress)
    {
        int done = (int)Math.Round(progress * BarWidth);
        return string.Format(
            CultureInfo.InvariantCulture, "[green]{0}[/][grey]{1}[/] {2:0}%", new string('━', done),
            new string('━', BarWidth - done), progress * 100);
    }

    private static string Number(long value) => value.ToString(CultureInfo.InvariantCulture);

    // What came from outside must not be taken for markup.
    private static string Plain(string text) => Markup.Escape(text);
}
