using System;
using System.Collections.Concurrent;
using System.IO;
using System.Runtime.InteropServices;
using System.Threading;
using Rabit.Terminal;
using Spectre.Console;

namespace Rabit.Tool.Running.Top;

/// <summary>
/// The full-screen table: samples, keys and signals come by one queue, and each has it painted again.
/// </summary>
internal sealed class TopScreen(TopSettings settings) : IDisposable
{
    private static readonly TimeSpan RepaintEvery = TimeSpan.FromSeconds(1);   // the window may have another size

    private readonly BlockingCollection<Action> _events = [];
    private readonly TopView _view = new(settings);
    private readonly TopKeys _keys = new(settings);
    private bool _isOver;
    private bool _isInterrupted;

    /// <summary>Whether the output is a terminal that supports it.</summary>
    public static bool IsPossible()
        => !Console.IsOutputRedirected && AnsiConsole.Profile.Capabilities.Ansi
            && AnsiConsole.Profile.Capabilities.Interactive;

    /// <summary>Until a key or a signal ends it.</summary>
    /// <returns>The exit code.</returns>
    public int Run(RunningChoice choice, DiagnosticsClient client, int everyMilliseconds)
    {
        using var feed = new TopFeed(
            choice, everyMilliseconds, (hello, sample) => Post(() => _view.Show(hello, sample)),
            fault => Post(() => _view.Fault = fault));
        using PosixSignalRegistration interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Quit);
        using PosixSignalRegistration terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Quit);
        feed.Start(client);
        if (!Console.IsInputRedirected)
            new Thread(ReadKeys) { IsBackground = true, Name = "keys" }.Start();
        var painter = new ScreenPainter(ScreenTerminal.OfConsole());
        painter.Begin();
        try
        {
            while (!_isOver)
            {
                if (_events.TryTake(out Action? first, RepaintEvery))
                    first();
                while (_events.TryTake(out Action? next))
                    next();
                painter.Paint((columns, rows) => _view.DrawScreen(columns, rows));
            }
        }
        finally
        {
            painter.End((columns, rows) => _view.DrawScreen(columns, rows - 1));
        }

        return _isInterrupted ? ToolExitCode.Interrupted : ToolExitCode.Done;
    }

    public void Dispose() => _events.Dispose();

    private void Post(Action action)
    {
        try
        {
            _events.Add(action);
        }
        catch (ObjectDisposedException)
        {
            // It is over.
        }
    }

    private void Quit(PosixSignalContext signal)
    {
        signal.Cancel = true;
        bool isInterrupt = signal.Signal == PosixSignal.SIGINT;
        Post(() =>
        {
            _isOver = true;
            _isInterrupted |= isInterrupt;
        });
    }

    private void ReadKeys()
    {
        try
        {
            while (true)
            {
                ConsoleKeyInfo key = Console.ReadKey(intercept: true);
                Post(() => _isOver |= !_keys.Press(key));
            }
        }
        catch (Exception e) when (e is InvalidOperationException or IOException)
        {
            // The terminal has closed, and its signal ends the program.
            Post(() => _isOver = true);
        }
    }
}
