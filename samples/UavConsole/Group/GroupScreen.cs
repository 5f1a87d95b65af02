using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.Linq;
using System.Threading.Tasks;
using Rabit.Terminal;
using Rabit.Uav.Reporting;
using Spectre.Console;

namespace UavConsole;

/// <summary>
/// The screen of a group: one map with all vehicles, a line for each of them, and the last decisions of all.
/// </summary>
/// <param name="flight">What it shows.</param>
/// <param name="keys">What the keys do, for the last line; null where there are none.</param>
/// <param name="refreshed">Called at each refresh; null for nothing.</param>
internal sealed class GroupScreen(GroupFlight flight, IKeyHints? keys = null, Action? refreshed = null)
{
    private const int NotesKept = 60;
    private const int MinMapRows = 6;
    private const int MinNotes = 4;

    private static readonly TimeSpan RefreshEvery = TimeSpan.FromMilliseconds(150);

    private readonly Queue<string> _notes = new();
    private readonly Stopwatch _wall = Stopwatch.StartNew();

    public void ShowUntilEnd(Task run)
    {
        ScreenTerminal terminal = ScreenTerminal.OfConsole();
        var painter = new ScreenPainter(terminal);
        painter.Begin();
        try
        {
            bool hasEnded = false;
            while (!hasEnded)
            {
                hasEnded = run.Wait(RefreshEvery);
                Refresh();
                painter.Paint((columns, rows) => Draw(columns, rows, terminal.IsUnicode));
            }
        }
        finally
        {
            painter.End((columns, rows) => Draw(columns, rows, terminal.IsUnicode));
        }
    }

    /// <param name="width">Columns of the terminal.</param>
    /// <param name="height">Its lines.</param>
    /// <param name="isUnicode">Whether it knows more than ASCII.</param>
    internal Rows Draw(int width, int height, bool isUnicode)
    {
        string hints = FlightText.Printable(keys?.Line ?? string.Empty);
        int free = height - flight.Vehicles.Count - (keys is null ? 2 : 3);
        int mapRows = width >= ScreenLayout.MinMapWidth && free >= MinMapRows + MinNotes ? free - MinNotes : 0;
        string[] lines =
        [
            $"[bold]{Markup.Escape(Text.Fit(Title(), width))}[/]",
            .. mapRows == 0
                ? []
                : MapMarkup.Lines(CharacterMap.Draw(
                    MapModel.Of(flight.Vehicles.Select(v => v.Monitor.Record).ToArray()), width, mapRows, isUnicode,
                    isAnnotated: true)),
            $"[grey]{Markup.Escape(Text.Fit(GroupText.Head, width))}[/]",
            .. flight.Vehicles.Select(v => Markup.Escape(Text.Fit(GroupText.Row(v), width))),
            .. _notes.Skip(_notes.Count - Math.Max(0, free - mapRows))
                .Select(n => $"[grey]{Markup.Escape(Text.Fit(FlightText.Printable(n), width))}[/]"),
            .. keys is null ? [] : new[] { $"[bold]{Markup.Escape(Text.Fit(hints, width))}[/]" },
        ];
        return new Rows(lines.Select(l => new Markup(l).Overflow(Overflow.Crop)));
    }

    private void Refresh()
    {
        foreach (GroupVehicle vehicle in flight.Vehicles)
            vehicle.Refresh();
        foreach (string line in GroupText.TakeLog(flight))
            _notes.Enqueue(line);
        while (_notes.Count > NotesKept)
            _notes.Dequeue();
        refreshed?.Invoke();
    }

    private string Title() => string.Format(
        CultureInfo.InvariantCulture, "{0}   {1} vehicles   {2} (x{3:0.0})", FlightText.Printable(flight.Mission.Name),
        flight.Vehicles.Count, FlightText.Clock(flight.Now),
        flight.Now.TotalSeconds / Math.Max(0.2, _wall.Elapsed.TotalSeconds));
}
