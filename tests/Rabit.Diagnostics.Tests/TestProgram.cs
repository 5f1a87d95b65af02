using System;
using System.IO;
using Rabit.Core;
using Rabit.Diagnostics.Serving;
using Rabit.Tests.Shared;

namespace Rabit.Diagnostics.Tests;

/// <summary>A program with diagnostics and two managers, in virtual time that only the test moves.</summary>
internal sealed class TestProgram : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public TestProgram(bool starts = true, Func<ClientLimits, ClientLimits>? limits = null)
    {
        Reactor = new RabitReactor(new ReactorOptions
        {
            Time = new VirtualTime(1),
            StopsOnSignals = false,
            Name = "main",
            Log = _ => { },
        });
        Reactor.Add(Source);
        Reactor.Add(Sink);
        var options = new DiagnosticsOptions { Program = "test", Folder = _folder.Sockets };
        options.Limits = limits?.Invoke(options.Limits) ?? options.Limits;
        Diagnostics = RabitDiagnostics.Open(options, Reactor);
        if (starts)
            Start();
    }

    public SourceManager Source { get; } = new();

    public SinkManager Sink { get; } = new();

    public RabitReactor Reactor { get; }

    public RabitDiagnostics Diagnostics { get; }

    public string Folder => _folder.Sockets;

    public void Start()
    {
        Reactor.Start();
        Reactor.RunFor(TimeSpan.Zero);
    }

    /// <summary>Connects, and reads the greeting.</summary>
    public TestClient Connect()
    {
        var client = new TestClient(Diagnostics.SocketPath!);
        client.Read("hello");
        return client;
    }

    /// <summary>Lets every user reach the socket, as no program does.</summary>
    public void OpenToAll()
    {
        const UnixFileMode All = (UnixFileMode)0b111_111_111;
        File.SetUnixFileMode(_folder.Path, All);
        File.SetUnixFileMode(_folder.Sockets, All);
        File.SetUnixFileMode(Diagnostics.SocketPath!, All);
    }

    /// <summary>Waits until the counters are so; the clients have threads of their own.</summary>
    public void Until(Func<DiagnosticsCounters, bool> condition)
    {
        var timeout = new TestTimeout();
        while (!condition(Diagnostics.Counters))
        {
            if (!timeout.TryWait())
                throw new TimeoutException($"It is {Diagnostics.Counters}.");
        }
    }

    public void Dispose()
    {
        Diagnostics.Dispose();
        Reactor.Dispose();
        _folder.Dispose();
    }
}
