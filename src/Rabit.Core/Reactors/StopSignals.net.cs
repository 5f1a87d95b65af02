using System;
using System.Runtime.InteropServices;

namespace Rabit.Core.Reactors;

/// <summary>
/// Ctrl-C, SIGTERM and SIGHUP, for the length of one run. The twin of this file serves frameworks without
/// PosixSignalRegistration.
/// </summary>
internal sealed class StopSignals : IDisposable
{
    private readonly PosixSignalRegistration[] _registrations;

    public StopSignals(Action<string> stop, Action<string> note)
    {
        _ = note;
        _registrations =
        [
            Register(PosixSignal.SIGINT, "Ctrl-C", stop), Register(PosixSignal.SIGTERM, "SIGTERM", stop),
            Register(PosixSignal.SIGHUP, "SIGHUP", stop),
        ];
    }

    public void Dispose()
    {
        foreach (PosixSignalRegistration registration in _registrations)
            registration.Dispose();
    }

    private static PosixSignalRegistration Register(PosixSignal signal, string name, Action<string> stop)
        => PosixSignalRegistration.Create(signal, context =>
        {
            // The run ends in order instead of the process at once.
            context.Cancel = true;
            stop(name);
        });
}
