using System.Collections.Generic;
using System.Linq;
using Rabit.Core;

namespace UavConsole;

/// <summary>Keeps the last entries of the log of the run that a person should see. Written by any thread, read by the view's.</summary>
internal sealed class RunLog
{
    private const int MaxKept = 200;

    private readonly Queue<RabitLogEntry> _entries = new();   // under its own lock

    public void Add(RabitLogEntry entry)
    {
        if (entry.Kind == RabitLogKind.Run)
            return;
        lock (_entries)
        {
            _entries.Enqueue(entry);
            if (_entries.Count > MaxKept)
                _entries.Dequeue();
        }
    }

    /// <summary>Takes out all entries, oldest first.</summary>
    public IReadOnlyList<RabitLogEntry> TakeAll()
    {
        lock (_entries)
        {
            RabitLogEntry[] entries = _entries.ToArray();
            _entries.Clear();
            return entries;
        }
    }
}
