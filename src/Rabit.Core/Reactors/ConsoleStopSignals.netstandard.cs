using System;

namespace Rabit.Core.Reactors;

/// <summary>
/// Ctrl-C through the console, and SIGTERM and SIGHUP where Mono has them. Beside the log on standard error the one
/// file that may touch the console.
/// </summary>
internal sealed class ConsoleStopSignals : IDisposable
{
    private readonly Action<string> _stop;
    private readonly ConsoleCancelEventHandler _onCancelKey;
    private readonly IDisposable? _unixSignals;

    public ConsoleStopSignals(Action<string> stop, Action<string> note)
    {
        _stop = stop;
        _onCancelKey = OnCancelKey;
#pragma warning disable RS0030 // The stop signals are the one exemption from the ban on the console.
        Console.CancelKeyPress += _onCancelKey;
#pragma warning restore RS0030
        _unixSignals = MonoStopSignals.TryCreate(stop);
        if (_unixSignals is null && Environment.OSVersion.Platform == PlatformID.Unix)
        {
            note("neither PosixSignalRegistration nor Mono.Posix is present: "
                + "SIGTERM and SIGHUP end the process without stopping the managers in order");
        }
    }

    public void Dispose()
    {
        _unixSignals?.Dispose();
#pragma warning disable RS0030 // See above.
        Console.CancelKeyPress -= _onCancelKey;
#pragma warning restore RS0030
    }

    private void OnCancelKey(object? sender, ConsoleCancelEventArgs e)
    {
        // Ctrl-Break and SIGQUIT (Ctrl-\) keep their meaning: who has nothing else left ends the process with them.
        if (e.SpecialKey != ConsoleSpecialKey.ControlC)
            return;
        e.Cancel = true;
        _stop("Ctrl-C");
    }
}
