using System;
using System.IO;
using System.Linq;
using System.Net.Sockets;
using Rabit.Core;
using Rabit.Diagnostics.Serving;
using Rabit.Diagnostics.Sockets;

namespace Rabit.Diagnostics;

/// <summary>
/// Lets the tool <c>rabit</c>, run by the same user, look into this program: managers, queues, messages and their
/// values, wiring. Open it before the reactor runs, and dispose it when the run is over.
/// </summary>
/// <remarks>
/// A Unix socket that one sleeping thread listens on; while no tool is connected that is all. Each of at most four
/// clients has a thread of its own, which reads statuses and messages as any code outside managers does: managers wait
/// for none of it. Diagnostics that cannot be opened are no reason to end a program: <see cref="Fault"/> says why.
/// </remarks>
/// <example>
/// <code>
/// var reactor = new RabitReactor { new Counter() };
/// using var diagnostics = RabitDiagnostics.Open(reactor);   // "rabit top" shows it
/// reactor.Run();
/// </code>
/// </example>
public sealed class RabitDiagnostics : IDisposable
{
    private readonly ServedProgram? _program;
    private readonly ClientGate? _gate;

    private RabitDiagnostics(string fault) => Fault = fault;

    private RabitDiagnostics(ServedProgram program, ClientGate gate, string path)
    {
        _program = program;
        _gate = gate;
        SocketPath = path;
    }

    /// <summary>The socket; null where <see cref="Fault"/> says why there is none.</summary>
    public string? SocketPath { get; }

    /// <summary>Why tools cannot connect; null where they can.</summary>
    public string? Fault { get; }

    /// <summary>What became of the clients so far. Any thread.</summary>
    public DiagnosticsCounters Counters => _gate?.Counters ?? default;

    /// <summary>Opens the diagnostics of a program with the default options.</summary>
    /// <param name="reactors">Its reactors, started or not, as for <see cref="Add"/>.</param>
    /// <returns>Never null; see <see cref="Fault"/>.</returns>
    public static RabitDiagnostics Open(params RabitReactor[] reactors) => Open(new DiagnosticsOptions(), reactors);

    /// <summary>Opens the diagnostics of a program.</summary>
    /// <param name="options">Name and folder.</param>
    /// <param name="reactors">Its reactors, started or not, as for <see cref="Add"/>.</param>
    /// <returns>Never null; see <see cref="Fault"/>.</returns>
    /// <exception cref="ArgumentException">A reactor is null.</exception>
    public static RabitDiagnostics Open(DiagnosticsOptions options, params RabitReactor[] reactors)
    {
        ArgumentNullException.ThrowIfNull(options);
        ArgumentNullException.ThrowIfNull(reactors);
        if (reactors.Contains(null))
            throw new ArgumentException("No reactor may be null.", nameof(reactors));
        if (!OperatingSystem.IsLinux())
            return new RabitDiagnostics(
                "Diagnostics need Linux: elsewhere a socket does not say whose client connects.");
        try
        {
            DiagnosticsSocket socket = DiagnosticsSocket.Open(
                options.Program ?? AppDomain.CurrentDomain.FriendlyName, options.Folder);
            var program = new ServedProgram(socket.Program, reactors, options.Clock);
            return new RabitDiagnostics(program, new ClientGate(socket, program, options.Limits), socket.Path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or SocketException
            or ArgumentException or NotSupportedException or DllNotFoundException or EntryPointNotFoundException)
        {
            // The surroundings: no folder, no right, no sockets.
            return new RabitDiagnostics("Diagnostics cannot be opened: " + e.Message);
        }
    }

    /// <summary>
    /// Shows one more reactor, also to clients that are connected: for hosts, which make their reactors later. Any
    /// thread, at any time; one that is shown already stays as it is.
    /// </summary>
    /// <param name="reactor">Started or not; it stays the caller's.</param>
    public void Add(RabitReactor reactor)
    {
        ArgumentNullException.ThrowIfNull(reactor);
        _program?.Add(reactor);
    }

    /// <summary>Disconnects all clients and removes the socket. A second call has no effect.</summary>
    public void Dispose() => _gate?.Dispose();
}
