using System;

namespace Rabit.Core.Reactors;

/// <summary>
/// Ctrl-C, SIGTERM and SIGHUP, for the length of one run. The netstandard2.0 build runs on several runtimes: where .NET
/// has PosixSignalRegistration (6.0 and later) it is used; elsewhere the console has Ctrl-C, and on Mono all three come
/// through UnixSignal of Mono.Posix. Both by reflection, so that no program needs to ship them.
/// </summary>
internal sealed class StopSignals(Action<string> stop, Action<string> note) : IDisposable
{
    private readonly IDisposable _source = PosixStopSignals.TryCreate(stop)
        ?? (IDisposable)new ConsoleStopSignals(stop, note);

    public void Dispose() => _source.Dispose();
}
