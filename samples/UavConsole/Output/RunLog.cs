using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Uav.Reporting;

namespace UavConsole;

/// <summary>
/// The log of the run: each entry becomes a line of the file, goes to the report, and waits for the view. Times are
/// those of the run's clock, so that the same flight in virtual time gives the same bytes. Any thread writes; one
/// reads, that of the view. Of several vehicles each has a log of its own, whose lines begin with a prefix.
/// </summary>
internal sealed class RunLog(LogFile? file = null, string prefix = "")
{
    private const int MaxKept = 200;

    private readonly object _gate = new();   // guards all below, and the file
    private readonly Queue<string> _lines = new();
    private string? _viewLoss;

    /// <summary>What the report shows.</summary>
    public FlightLog Flight { get; } = new();

    /// <summary>What the file has lost, for people; null where nothing, and where there is none.</summary>
    public string? Loss
    {
        get
        {
            lock (_gate)
                return file?.Loss;
        }
    }

    /// <summary>Why the view ended before the flight; null where it did not.</summary>
    public string? ViewLoss
    {
        get
        {
            lock (_gate)
                return _viewLoss;
        }
    }

    /// <summary>The view ended before the flight.</summary>
    public void NoteViewLost(string why)
    {
        lock (_gate)
            _viewLoss = "the screen was lost in the flight: " + why;
    }

    public void Add(RabitLogEntry entry)
    {
        if (entry.Kind == RabitLogKind.Run)
            return;
        lock (_gate)
        {
            Flight.Add(entry);
            Keep(entry.ToString());
        }
    }

    /// <summary>Adds a line of the program's own, for the file and the view.</summary>
    /// <param name="time">By the clock of the run.</param>
    /// <param name="text">What it says.</param>
    public void Note(TimeSpan time, string text)
    {
        lock (_gate)
            Keep(FlightText.TimeStamp(time) + "UavConsole: " + text);
    }

    /// <summary>Takes out the last lines for the view, oldest first.</summary>
    public IReadOnlyList<string> TakeAll()
    {
        lock (_gate)
        {
            string[] lines = _lines.ToArray();
            _lines.Clear();
            return lines;
        }
    }

    private void Keep(string line)
    {
        line = prefix + line;
        file?.WriteLine(FlightText.Printable(line));
        _lines.Enqueue(line);
        if (_lines.Count > MaxKept)
            _lines.Dequeue();
    }
}
