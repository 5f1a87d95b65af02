using System;
using System.Collections.Generic;

namespace Rabit.Core.Tests.Contracts;

/// <summary>A target that never blocks and keeps what was written.</summary>
internal sealed class ScriptedTarget(TestBoard board) : IWriterTarget<int>
{
    private readonly List<int> _written = [];   // under board.Gate

    public bool Blocks => false;

    public Action<int>? OnWrite { get; set; }

    public Action? OnOpen { get; set; }

    public Action? OnClose { get; set; }

    public IReadOnlyList<int> Written
    {
        get
        {
            lock (board.Gate)
                return _written.ToArray();
        }
    }

    public void Open()
    {
        board.Write("open");
        OnOpen?.Invoke();
    }

    public void Write(in int value)
    {
        OnWrite?.Invoke(value);
        lock (board.Gate)
            _written.Add(value);
        board.Changed();
    }

    public void Unblock()
    {
    }

    public void Close()
    {
        board.Write("close");
        OnClose?.Invoke();
    }
}
