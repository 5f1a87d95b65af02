using System;
using System.Collections.Generic;
using System.Net.Sockets;
using System.Threading;
using Rabit.Diagnostics.Protocol;
using Rabit.Diagnostics.Sockets;

namespace Rabit.Diagnostics.Serving;

/// <summary>Lets clients in, on a thread that sleeps until one connects; each gets a thread of its own.</summary>
internal sealed class ClientGate : IDisposable
{
    private static readonly TimeSpan EndTimeout = TimeSpan.FromSeconds(2);
    private static readonly TimeSpan RetryDelay = TimeSpan.FromSeconds(1);

    private readonly DiagnosticsSocket _socket;
    private readonly ServedProgram _program;
    private readonly ClientLimits _limits;
    private readonly ClientCounters _counters = new();
    private readonly ManualResetEventSlim _ending = new();
    private readonly Thread _thread;

    private readonly Lock _lock = new();
    private readonly List<(ClientSession Session, Thread Thread)> _sessions = [];   // under _lock
    private bool _isDisposed;                                                       // same

    public ClientGate(DiagnosticsSocket socket, ServedProgram program, ClientLimits limits)
    {
        _socket = socket;
        _program = program;
        _limits = limits;
        _thread = new Thread(Accept) { Name = "diagnostics", IsBackground = true };
        _thread.Start();
    }

    public DiagnosticsCounters Counters => _counters.Read();

    public void Dispose()
    {
        (ClientSession Session, Thread Thread)[] sessions;
        lock (_lock)
        {
            if (_isDisposed)
                return;
            _isDisposed = true;
            sessions = [.. _sessions];
        }

        _ending.Set();
        _socket.Dispose();
        foreach ((ClientSession session, _) in sessions)
            session.End();
        _thread.Join(EndTimeout);
        foreach ((_, Thread thread) in sessions)
            thread.Join(EndTimeout);
    }

    private void Accept()
    {
        while (!_ending.IsSet)
        {
            try
            {
                LetIn(_socket.Listener.Accept());
            }
            catch (Exception e) when (e is SocketException or ObjectDisposedException or OutOfMemoryException)
            {
                // The socket was closed, or this process has no more file descriptors or threads: those who wait can
                // wait, and asking again at once would take a processor.
                _ending.Wait(RetryDelay);
            }
        }
    }

    private void LetIn(Socket client)
    {
        string? refusal = FindRefusal(client);
        if (refusal is not null)
        {
            using (client)
                ClientLines.TryRefuse(client, refusal);
            return;
        }

        var session = new ClientSession(client, _program, _limits, _counters);
        var thread = new Thread(() => Serve(session)) { Name = "diagnostics client", IsBackground = true };
        lock (_lock)
        {
            if (_isDisposed)
                session.End();
            _sessions.Add((session, thread));
        }

        try
        {
            thread.Start();
        }
        catch (OutOfMemoryException)
        {
            // No more threads: this client is the one to go.
            Leave(session);
            throw;
        }
    }

    private string? FindRefusal(Socket client)
    {
        uint user;
        try
        {
            user = PeerUser.Of(client);
        }
        catch (SocketException)
        {
            // It has gone already, or the system does not say who it is.
            _counters.Refuse();
            return "The system does not say which user this client is.";
        }

        if (user != PeerUser.Own && user != PeerUser.Root)
        {
            _counters.Refuse();
            return "This program is of another user.";
        }

        return _counters.TryAdd(_limits.MaxClients)
            ? null
            : FormattableString.Invariant(
                $"There are {_limits.MaxClients} clients already; try again when one has gone.");
    }

    private void Serve(ClientSession session)
    {
        session.Run();
        Leave(session);
    }

    private void Leave(ClientSession session)
    {
        lock (_lock)
            _sessions.RemoveAll(s => s.Session == session);
        session.Dispose();
        _counters.Remove();
    }
}
