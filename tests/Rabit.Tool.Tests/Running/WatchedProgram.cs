using System;
using System.IO;
using Rabit.Core;
using Rabit.Diagnostics;

namespace Rabit.Tool.Tests.Running;

/// <summary>
/// A program that the tool can look into: this process, with diagnostics in a folder of the test. Its managers run in
/// real time until it ends.
/// </summary>
internal sealed class WatchedProgram : IDisposable
{
    private readonly RabitReactor _reactor;
    private readonly RabitDiagnostics _diagnostics;
    private readonly string _folder;
    private readonly bool _ownsFolder;

    public WatchedProgram(string name = "watched", string? folder = null)
    {
        _ownsFolder = folder is null;
        _folder = folder ?? Directory.CreateTempSubdirectory("rt").FullName;
        _reactor = new RabitReactor(new ReactorOptions { StopsOnSignals = false, Name = "main", Log = _ => { } });
        _reactor.Add(new Ticker());
        _reactor.Add(new Hoarder());
        _diagnostics = RabitDiagnostics.Open(
            new DiagnosticsOptions { Program = name, Folder = Path.Combine(_folder, "rabit") }, _reactor);
        if (_diagnostics.Fault is not null)
            throw new InvalidOperationException(_diagnostics.Fault);
        _reactor.Start();
    }

    /// <summary>For another program beside it.</summary>
    public string Folder => _folder;

    /// <summary>For <c>--folder</c>.</summary>
    public string Sockets => Path.Combine(_folder, "rabit");

    public void Dispose()
    {
        _diagnostics.Dispose();
        _reactor.Dispose();
        if (_ownsFolder)
            Directory.Delete(_folder, recursive: true);
    }

    private sealed class Ticker : RabitManager
    {
        private readonly MessagePublisher<int> _count;
        private readonly QueueSender<int> _numbers;

        public Ticker()
            : base("ticker")
        {
            _count = Publish<int>("count");
            _numbers = Send<int>("numbers");
            Period = TimeSpan.FromMilliseconds(20);
        }

        protected override void ExecuteUnitOfWork()
        {
            _count.Post(_count.Value + 1);
            _numbers.Push(_count.Value);
        }
    }

    // Takes nothing out: the queue is full and drops.
    private sealed class Hoarder : RabitManager
    {
        public Hoarder()
            : base("hoarder")
        {
            Receive<int>("numbers", capacity: 2, QueueFullMode.DropOldest);
            Subscribe<int>("count");
        }

        protected override void ExecuteUnitOfWork()
        {
        }
    }
}
