using System;
using Rabit.Core;
using Rabit.Diagnostics;

namespace UavConsole;

/// <summary>Lets the tool "rabit" look into the run; costs nothing while it does not.</summary>
internal static class RunDiagnostics
{
    public static IDisposable Open(RabitReactor reactor, RunLog log)
    {
        RabitDiagnostics diagnostics = RabitDiagnostics.Open(reactor);
        if (diagnostics.Fault is not null)
            log.Note(reactor.Now, diagnostics.Fault);
        return diagnostics;
    }
}
