using System;
using System.Collections.Generic;

namespace Rabit.Core.Tests.Contracts;

/// <summary>
/// A source that never blocks: it gives its values one by one, each not before its time, and then ends.
/// </summary>
internal sealed class ScriptedSource(TestBoard board, TimeSpan interval, params int[] values) : IReaderSource<int>
{
    private readonly Queue<int> _values = new(values);
    private TimeSpan _due;
    private ReaderContext? _context;

    public bool Blocks => false;

    /// <summary>Called before each read.</summary>
    public Action? OnRead { get; set; }

    public Action? OnOpen { get; set; }

    public Action? OnClose { get; set; }

    /// <summary>What comes after the last value.</summary>
    public ReaderStep AtTheEnd { get; set; } = ReaderStep.Ended;

    public ReaderContext Context => _context!;

    public void Open(ReaderContext context)
    {
        _context = context;
        board.Write("open");
        OnOpen?.Invoke();
    }

    public ReaderStep Read(out int value)
    {
        OnRead?.Invoke();
        value = 0;
        if (_values.Count == 0)
            return AtTheEnd;
        if (_context!.Now < _due)
            return ReaderStep.WaitUntil(_due);
        value = _values.Dequeue();
        _due = _context.Now + interval;
        return ReaderStep.Value;
    }

    public void Unblock()
    {
    }

    public void Close()
    {
        board.Write("close");
        OnClose?.Invoke();
    }

    /// <summary>From outside: more values, and a signal.</summary>
    public void Add(int value)
    {
        _values.Enqueue(value);
        Context.Signal();
    }
}
