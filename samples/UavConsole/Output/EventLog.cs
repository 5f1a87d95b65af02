using System;
using System.Collections.Generic;
using System.Text;
using Rabit.Core;

namespace UavConsole;

/// <summary>
/// The log of the run, whole: each entry a line of the file as it comes, and the first and last ones kept for the report. Times are
/// those of the run's clock, so that the same flight under virtual time gives the same bytes. Any thread.
/// </summary>
internal sealed class EventLog(OutputFile? file)
{
    // Of the first ones and of the last ones.
    private const int MaxKept = 2_000;

    private readonly object _gate = new();   // guards all below, and the file
    private readonly List<FlightEvent> _first = [];
    private readonly Queue<FlightEvent> _last = new();
    private string? _failure;
    private long _count;

    public void Add(RabitLogEntry entry)
    {
        if (entry.Kind == RabitLogKind.Run)
            return;
        lock (_gate)
        {
            _count++;
            Keep(new FlightEvent(entry.Time, entry.Kind, entry.Source, entry.Text));
            WriteLine(Text.Printable(entry.ToString()));
        }
    }

    /// <summary>The entries that are kept, oldest first, and how many there were in all.</summary>
    public (IReadOnlyList<FlightEvent> Events, long Count) TakeAll()
    {
        lock (_gate)
            return ([.. _first, .. _last], _count);
    }

    /// <summary>Why the file could not be written to its end; null where it was, and where there is none.</summary>
    public string? Failure
    {
        get
        {
            lock (_gate)
                return _failure;
        }
    }

    private void Keep(FlightEvent e)
    {
        if (_first.Count < MaxKept)
        {
            _first.Add(e);
            return;
        }

        _last.Enqueue(e);
        if (_last.Count > MaxKept)
            _last.Dequeue();
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
