using System;
using System.Collections.Generic;
using System.Text;
using Rabit.Core;
using Rabit.Uav.Reporting;

namespace UavConsole;

/// <summary>
/// The log of the run: each entry becomes a line of the file, goes to the report, and waits for the view. Times are
/// those of the run's clock, so that the same flight in virtual time gives the same bytes. Any thread writes; one
/// reads, that of the view.
/// </summary>
internal sealed class RunLog(OutputFile? file = null)
{
    private const int MaxKept = 200;

    private readonly object _gate = new();   // guards all below, and the file
    private readonly Queue<RabitLogEntry> _entries = new();
    private string? _failure;
    private string? _viewLoss;

    /// <summary>What the report shows.</summary>
    public FlightLog Flight { get; } = new();

    /// <summary>Why the file could not be written to its end; null where it was, and where there is none.</summary>
    public string? Failure
    {
        get
        {
            lock (_gate)
                return _failure;
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
            WriteLine(FlightText.Printable(entry.ToString()));
            _entries.Enqueue(entry);
            if (_entries.Count > MaxKept)
                _entries.Dequeue();
        }
    }

    /// <summary>Takes out the last entries for the view, oldest first.</summary>
    public IReadOnlyList<RabitLogEntry> TakeAll()
    {
        lock (_gate)
        {
            RabitLogEntry[] entries = _entries.ToArray();
            _entries.Clear();
            return entries;
        }
    }

    // A full disk ends the file, not the flight.
    private void WriteLine(string line)
    {
        if (file is null || _failure is not null)
            return;
        try
        {
            file.Write(Encoding.UTF8.GetBytes(line + "\n"));
        }
        catch (ArgumentException e)
        {
            _failure = e.Message;
        }
    }
}
