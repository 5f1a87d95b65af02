using System;
using System.Collections.Generic;
using System.Threading.Tasks;
using Rabit.Terminal;
using Spectre.Console;

namespace UavConsole;

/// <summary>
/// The view for a terminal: a mission with its map, or a flight that is watched, several times a second, in the size
/// that the terminal has at the moment.
/// </summary>
internal sealed class LiveScreen
{
    private const int DefaultWidth = 80;
    private const int DefaultHeight = 24;
    private const int NotesKept = 60;
    private static readonly TimeSpan RefreshEvery = TimeSpan.FromMilliseconds(150);

    private readonly FlightMonitor _monitor;
    private readonly RunLog _log;
    private readonly MissionView? _mission;
    private readonly VehicleView _vehicle;
    private readonly Queue<string> _notes = new();

    /// <param name="monitor">What to show.</param>
    /// <param name="log">Its last entries are shown too.</param>
    /// <param name="showsMission">Whether a mission is flown.</param>
    /// <param name="notice">A line that always stands there; null for none.</param>
    /// <param name="keys">What the keys do, for the last line; null where there are none.</param>
    public LiveScreen(
        FlightMonitor monitor, RunLog log, bool showsMission = false, string? notice = null, IKeyHints? keys = null)
    {
        (_monitor, _log) = (monitor, log);
        _vehicle = new VehicleView(monitor, notice);
        _mission = showsMission ? new MissionView(monitor, keys) : null;
    }

    /// <summary>Whether the output is a terminal that supports the screen.</summary>
    public static bool IsPossible()
        => !Console.IsOutputRedirected && AnsiConsole.Profile.Capabilities.Ansi
            && AnsiConsole.Profile.Capabilities.Interactive;

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
                _monitor.Refresh();
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
    internal Rows Draw(int width = DefaultWidth, int height = DefaultHeight, bool isUnicode = true)
    {
        foreach (string line in _log.TakeAll())
            _notes.Enqueue(line);
        while (_notes.Count > NotesKept)
            _notes.Dequeue();
        return _mission is null
            ? _vehicle.Draw(_notes, width)
            : _mission.Draw(_notes, width, height, isUnicode);
    }
}
