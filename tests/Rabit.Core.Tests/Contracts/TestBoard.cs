using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Where managers write down what they did, on any thread, and where the test waits for it.</summary>
internal sealed class TestBoard
{
    private readonly List<string> _entries = [];   // under Gate

    /// <summary>Pulsed at every change that a test may wait for.</summary>
    public object Gate { get; } = new();

    public IReadOnlyList<string> Entries
    {
        get
        {
            lock (Gate)
                return _entries.ToArray();
        }
    }

    public void Write(string entry)
    {
        lock (Gate)
        {
            _entries.Add(entry);
            Monitor.PulseAll(Gate);
        }
    }

    public int Count(string entry) => Entries.Count(e => string.Equals(e, entry, StringComparison.Ordinal));

    /// <summary>Makes a waiting test check again.</summary>
    public void Changed()
    {
        lock (Gate)
            Monitor.PulseAll(Gate);
    }
}
