using System;
using System.Threading;

namespace Rabit.Tool;

/// <summary>
/// Ctrl-C while output is written: the command ends behind the line that it is at. Where that takes long, since it
/// waits for input or for a reader of its output, the process ends all the same.
/// </summary>
internal sealed class Interruption : IDisposable
{
    private static readonly TimeSpan MaxEnd = TimeSpan.FromSeconds(1);

    private readonly ManualResetEventSlim _ended = new();
    private int _requested;

    public Interruption() => Console.CancelKeyPress += Take;

    /// <summary>Whether Ctrl-C was pressed. Any thread.</summary>
    public bool IsRequested => Volatile.Read(ref _requested) != 0;

    // The event is not disposed: a signal may be waiting for it, and it holds no handle.
    public void Dispose()
    {
        Console.CancelKeyPress -= Take;
        _ended.Set();
    }

    private void Take(object? sender, ConsoleCancelEventArgs e)
    {
        bool isFirst = Interlocked.Exchange(ref _requested, 1) == 0;
        e.Cancel = isFirst && e.SpecialKey == ConsoleSpecialKey.ControlC && _ended.Wait(MaxEnd);
    }
}
