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
/// The screen of a mission: the map, beside it how far it is, below it the managers and the last decisions. Plain lines
/// without map and managers where the terminal is small.
/// </summary>
internal sealed class MissionView(FlightMonitor monitor, IKeyHints? keys = null)
{
    private const string Blank = " ";   // markup without a character is no line

    public Rows Draw(IReadOnlyCollection<string> notes, int width, int height, bool isUnicode)
    {
        var layout = new ScreenLayout(width, height, monitor.Managers.Count, keys is not null);
        List<string> lines =
        [
            Title(width),
            .. layout.HasMap ? MapAndPanel(layout, isUnicode) : Panel(layout),
            .. layout.ShowsManagerTable ? ManagerTable(width) : layout.HasMap ? ManagerNames(width) : [],
            .. LastOf(notes, layout.NoteRows, width),
        ];
        if (keys is not null)
            lines.Add($"[bold]{Markup.Escape(Text.Fit(FlightText.Printable(keys.Line), width))}[/]");
        return new Rows(lines.Select(l => new Markup(l).Overflow(Overflow.Crop)));
    }

    // The keys stay in the last line of the screen.
    private static IEnumerable<string> LastOf(IReadOnlyCollection<string> notes, int count, int width)
    {
        string[] last = [.. notes.Skip(notes.Count - count)];
        return last.Concat(Enumerable.Repeat(string.Empty, count - last.Length))
            .Select(n => $"[grey]{Markup.Escape(Text.Fit(FlightText.Printable(n), width))}[/]");
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

    private IEnumerable<string> MapAndPanel(ScreenLayout layout, bool isUnicode)
    {
        IReadOnlyList<string> left = IsChecklistShown()
            ? ChecklistPane.Draw(monitor.Preflight, layout.MapColumns, layout.PanelRows)
            : MapMarkup.Lines(CharacterMap.Draw(
                MapModel.Of(monitor.Record), layout.MapColumns, layout.PanelRows, isUnicode, isAnnotated: true));
        IReadOnlyList<string> right = new MissionPanel(monitor, layout.PanelWidth).Draw(layout.PanelRows);
        for (int row = 0; row < layout.PanelRows; row++)
            yield return left[row] + "  " + (row < right.Count ? right[row] : string.Empty);
    }

    private IEnumerable<string> Panel(ScreenLayout layout)
    {
        IReadOnlyList<string> lines = IsChecklistShown() && layout.PanelRows >= 3
            ? ChecklistPane.Draw(monitor.Preflight, layout.PanelWidth, layout.PanelRows)
            : new MissionPanel(monitor, layout.PanelWidth).Draw(layout.PanelRows);
        return lines.Concat(Enumerable.Repeat(Blank, layout.PanelRows - lines.Count));
    }

    // Two lines, for a small screen: who does not work is first, and red.
    private IEnumerable<string> ManagerNames(int width)
    {
        (string Name, ManagerStatus Status)[] managers =
        [
            .. monitor.Managers.Select((s, index) => (monitor.ManagerNames[index], s))
                .OrderByDescending(m => IsFaulty(m.s)),
        ];
        var lines = new List<string>();
        var line = new StringBuilder();
        int used = 0;
        foreach ((string name, ManagerStatus status) in managers)
        {
            string text = IsFaulty(status) ? $"{name} {status.State} {FlightText.Number(status.Faults)}!" : name;
            if (used > 0 && used + text.Length + 2 > width)
            {
                lines.Add(line.ToString());
                line.Clear();
                used = 0;
            }

            line.Append($"[{(IsFaulty(status) ? "red" : "grey")}]{Markup.Escape(Text.Fit(text, text.Length))}[/]  ");
            used += text.Length + 2;
        }

        lines.Add(line.ToString());
        return lines.Concat([Blank, Blank]).Take(2);
    }

    // Two managers on a line, so that the map has room.
    private IEnumerable<string> ManagerTable(int width)
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
        return $"[{(IsFaulty(status) ? "red" : "default")}]{Markup.Escape(Text.Fit(line, width))}[/]";
    }

    private static bool IsFaulty(in ManagerStatus status) => status.Faults > 0
        || status.State is ManagerState.Faulted or ManagerState.Restarting or ManagerState.Hanging;

    private static string ManagerLine(string name, string state, string runs, string work, string faults)
        => $"{Text.Fit(name, 18)}{Text.Fit(state, 8)}{runs,6}{work,5}{faults,2}";
}
