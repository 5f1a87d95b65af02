using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Rabit.Core;
using Rabit.Uav.Messages;
using Rabit.Uav.Reporting;
using Spectre.Console;

namespace UavConsole;

/// <summary>
/// The screen of a mission: the map, beside it how far it is, below it the managers and the last decisions. Fits 80
/// by 24.
/// </summary>
internal sealed class MissionView(FlightMonitor monitor, IKeyHints? keys = null)
{
    private const int PanelWidth = 38;
    private const int NotesShown = 3;
    private const int WidestMap = 110;
    private const int MaxMapHeight = 40;
    private const int BarWidth = 20;
    private const int TargetsShown = 5;

    // What the operator can do; a stop after a takeover sends nothing.
    private static readonly string[] TakenOverHints =
    [
        "nothing is commanded. To command again", "stop (Ctrl-C), and start with --hold,", "--return or --resume FILE",
    ];

    public Rows Draw(IEnumerable<string> notes, int width, int height, bool isUnicode)
    {
        // One line stays free for the cursor.
        int managerRows = ((monitor.Managers.Count + 1) / 2) + 1;
        int keyRows = keys is null ? 0 : 1;
        int mapRows = Math.Min(MaxMapHeight, Math.Max(8, height - managerRows - NotesShown - 2 - keyRows));
        int mapColumns = Math.Min(WidestMap, width - PanelWidth - 2);
        IReadOnlyList<string> left = IsChecklistShown()
            ? ChecklistPane.Draw(monitor.Preflight, mapColumns, mapRows)
            : MapLines(CharacterMap.Draw(MapModel.Of(monitor.Record), mapColumns, mapRows, isUnicode));
        List<string> panel = Panel();

        var lines = new List<string> { Title(width) };
        for (int row = 0; row < mapRows; row++)
            lines.Add(left[row] + "  " + (row < panel.Count ? panel[row] : string.Empty));
        lines.AddRange(Managers(width));
        string[] last = notes.ToArray();
        lines.AddRange(
            last.Skip(last.Length - NotesShown)
                .Select(n => $"[grey]{Markup.Escape(Text.Fit(FlightText.Printable(n), width))}[/]"));
        if (keys is not null)
            lines.Add($"[bold]{Markup.Escape(Text.Fit(FlightText.Printable(keys.Line), width))}[/]");
        return new Rows(lines.Select(l => new Markup(l).Overflow(Overflow.Crop)));
    }

    // It is judged until the motors run.
    private bool IsChecklistShown() => monitor.Preflight.IsComplete && !monitor.Vehicle.IsArmed
        && monitor.Record.Mission.Phase is MissionPhase.WaitingForVehicle or MissionPhase.Arming;

    private string Title(int width)
    {
        FlightRecord record = monitor.Record;
        string name = record.Mission.Plan?.Name ?? "mission";
        string pace = monitor.Pace > 0
            ? string.Format(
                CultureInfo.InvariantCulture, "   {0} (x{1:0.0})", FlightText.Clock(monitor.Now), monitor.Pace)
            : string.Empty;
        string vehicle = Text.Vehicle(monitor.Vehicle);
        return $"[bold]{Markup.Escape(Text.Fit(FlightText.Printable($"{name}{pace}   {vehicle}"), width))}[/]";
    }

    private List<string> Panel()
    {
        FlightRecord record = monitor.Record;
        MissionStatus mission = record.Mission;
        var lines = new List<string>
        {
            Field(
                "phase", PhaseText(record),
                mission.Phase is MissionPhase.Failed or MissionPhase.HandedOver ? "red" : "bold"),
            Field(
                string.Empty, mission.Aborted is null ? mission.Text ?? string.Empty : "given up: " + mission.Aborted,
                mission.Aborted is null ? "grey" : "yellow"),
            $"[grey]{"covered",-9}[/]{Bar(mission.Coverage)}",
            Field("lanes", LaneText(mission), "default"),
            Field("vehicle", VehicleText(monitor.Vehicle), "default"),
            Field(string.Empty, string.Format(
                CultureInfo.InvariantCulture, "{0:0.0} m high, {1:0.0} m/s", monitor.Vehicle.HeightAboveHomeMetres,
                Speed(monitor.Vehicle)), "default"),
            Field("battery", Text.Battery(monitor.Vehicle), "default"),
            Field("energy", Text.Energy(mission.Energy), mission.Energy.MustReturn ? "yellow" : "default"),
            Field("health", FlightText.Health(monitor.Health), HealthColour(monitor.Health.Level)),
        };
        if (mission.Phase == MissionPhase.HandedOver && monitor.Vehicle.IsArmed)
            lines.AddRange(TakenOverHints.Select(h => $"[yellow]{Markup.Escape(h)}[/]"));
        lines.AddRange(Targets(record.Tracks));
        return lines;
    }

    private static string PhaseText(FlightRecord record)
    {
        string text = FlightText.Phase(record.Mission.Phase);
        return record.Authority.State == CommandAuthorityState.TakenAway && record.Authority.TakenBy is { } by
            ? $"{text}: {by}"
            : text;
    }

    private static string LaneText(in MissionStatus mission)
        => $"{FlightText.Number(mission.LanesFlown)} of {FlightText.Number((mission.Plan?.Lanes.Length ?? 0) / 2)} "
            + $"flown, {FlightText.Number(mission.Revisits)} revisits";

    private static string VehicleText(in VehicleState vehicle)
        => vehicle.SystemId == 0 ? "not connected yet" : $"{vehicle.Mode}, {(vehicle.IsArmed ? "armed" : "disarmed")}";

    private static double Speed(in VehicleState vehicle)
        => Math.Sqrt(
            (vehicle.VelocityNed.North * vehicle.VelocityNed.North)
                + (vehicle.VelocityNed.East * vehicle.VelocityNed.East));

    private static IEnumerable<string> Targets(TrackList tracks)
    {
        TargetTrack[] shown = tracks.Tracks.Where(t => t.State != TrackState.Tentative).ToArray();
        yield return Field(
            "targets",
            $"{FlightText.Number(tracks.Confirmed.Count())} confirmed, "
                + $"{FlightText.Number(tracks.Tracks.Length - shown.Length)} tentative",
            "default");
        foreach (TargetTrack track in shown.Skip(shown.Length - TargetsShown))
        {
            string text = string.Format(
                CultureInfo.InvariantCulture,
                "{0,3} {1} ±{2:0.0} m, {3} reports{4}",
                track.Id,
                TargetClassNames.Name(track.Class),
                track.Covariance.HalfMajorAxis95Metres,
                track.Reports,
                track.State == TrackState.Lost ? ", lost" : string.Empty);
            yield return $"[{InkStyle(TargetLetters.Ink(track.Class))}]{Markup.Escape(Text.Fit(text, PanelWidth))}[/]";
        }
    }

    // Two managers on a line, so that the map has room.
    private IEnumerable<string> Managers(int width)
    {
        int half = (width - 2) / 2;
        yield return $"[grey]{Text.Fit(ManagerLine("manager", "state", "runs", "ms", "!"), half)}  "
            + $"{Text.Fit(ManagerLine("manager", "state", "runs", "ms", "!"), half)}[/]";
        for (int index = 0; index < monitor.Managers.Count; index += 2)
            yield return Manager(index, half) + "  "
                + (index + 1 < monitor.Managers.Count ? Manager(index + 1, half) : string.Empty);
    }

    private string Manager(int index, int width)
    {
        ManagerStatus status = monitor.Managers[index];
        string line = ManagerLine(
            monitor.ManagerNames[index],
            status.State.ToString(),
            FlightText.Number(status.Runs),
            FlightText.Number(monitor.UnitOfWorkTimeOf(index).Mean.TotalMilliseconds, "0.00"),
            FlightText.Number(status.Faults));
        string colour = status.Faults > 0
            || status.State is ManagerState.Faulted or ManagerState.Restarting or ManagerState.Hanging
            ? "red"
            : "default";
        return $"[{colour}]{Markup.Escape(Text.Fit(line, width))}[/]";
    }

    private static string ManagerLine(string name, string state, string runs, string work, string faults)
        => $"{Text.Fit(name, 18)}{Text.Fit(state, 8)}{runs,6}{work,5}{faults,2}";

    private static string Field(string name, string text, string style)
        => $"[grey]{name,-9}[/][{style}]"
            + Markup.Escape(Text.Fit(FlightText.Printable(text), PanelWidth - 9).TrimEnd()) + "[/]";

    private static string Bar(double part)
    {
        double known = double.IsNaN(part) ? 0 : Math.Max(0, Math.Min(1, part));
        int done = (int)Math.Round(known * BarWidth);
        return string.Format(
            CultureInfo.InvariantCulture, "[green]{0}[/][grey]{1}[/] {2:0.0}%", new string('━', done),
            new string('━', BarWidth - done), known * 100);
    }

    private static string[] MapLines(MapPicture map)
        => [.. Enumerable.Range(0, map.Lines.Count).Select(row => MapLine(map, row))];

    private static string MapLine(MapPicture map, int row)
    {
        string line = map.Lines[row];
        var text = new StringBuilder();
        for (int first = 0; first < line.Length;)
        {
            int end = first + 1;
            while (end < line.Length && map.InkAt(end, row) == map.InkAt(first, row))
                end++;
            text.Append('[').Append(InkStyle(map.InkAt(first, row))).Append(']')
                .Append(Markup.Escape(line.Substring(first, end - first))).Append("[/]");
            first = end;
        }

        return text.ToString();
    }

    private static string InkStyle(MapInk ink) => ink switch
    {
        MapInk.Lane => "grey35",
        MapInk.Area => "grey62",
        MapInk.Path => "deepskyblue1",
        MapInk.Ellipse => "grey74",
        MapInk.Home => "bold white",
        MapInk.Tentative => "grey74",
        MapInk.Red => "bold red",
        MapInk.Orange => "bold darkorange",
        MapInk.Blue => "bold dodgerblue1",
        MapInk.Yellow => "bold yellow",
        MapInk.Magenta => "bold magenta1",
        MapInk.Vehicle => "bold lime",
        _ => "default",
    };

    private static string HealthColour(HealthLevel level) => level switch
    {
        HealthLevel.Good => "green",
        HealthLevel.Warning => "yellow",
        HealthLevel.Critical => "red",
        _ => "grey",
    };
}
