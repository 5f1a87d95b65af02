using System;
using System.IO;
using Rabit.Core;

namespace UavConsole;

/// <summary>There are no diagnostics here: they need the Unix sockets of .NET.</summary>
internal static class RunDiagnostics
{
    public static IDisposable Open(RabitReactor reactor, RunLog log) => Stream.Null;
}
