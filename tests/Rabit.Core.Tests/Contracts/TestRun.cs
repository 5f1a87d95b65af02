using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>
/// A reactor under test: scripted managers, a board, the log, and a way to go on until something is so.
/// </summary>
internal sealed class TestRun : IDisposable
{
    private readonly TimeKind _kind;
    private readonly List<RabitLogEntry> _log = [];   // under Board.Gate
    private readonly Dictionary<RabitManager, MessageSubscriber<ManagerStatus>> _statuses = [];
    private bool _hasStarted;
    private ReactorResult? _result;

    public TestRun(TimeKind kind, Action<ReactorOptions>? configure = null)
    {
        _kind = kind;
        var options = new ReactorOptions
        {
            Time = kind.Create(),
            Log = Write,
            StopsOnSignals = false,
            StopTimeout = TestTimeout.Limit,
        };
        configure?.Invoke(options);
        Reactor = new RabitReactor(options);
    }

    public RabitReactor Reactor { get; }

    public TestBoard Board { get; } = new();

    public IReadOnlyList<RabitLogEntry> Log
    {
        get
        {
            lock (Board.Gate)
                return _log.ToArray();
        }
    }

    public ScriptedManager Add(string name)
    {
        var manager = new ScriptedManager(name, Board);
        Reactor.Add(manager);
        MessageSubscriber<ManagerStatus> status = Reactor.Workspace.SubscribeToStatus(name);
        status.OnPost(_ => Board.Changed());
        _statuses[manager] = status;
        return manager;
    }

    public void Start()
    {
        Reactor.Start();
        _hasStarted = true;
    }

    /// <summary>Starts, and comes back when every scripted manager has ended its first unit of work.</summary>
    public void StartAndSettle()
    {
        Start();
        foreach (RabitManager manager in _statuses.Keys)
            Until(() => StatusOf(manager).Runs > 0, $"{manager.Name} ends its first unit of work");
    }

    /// <summary>Lets the run go on until something is so; fails the test if it does not come so.</summary>
    public void Until(Func<bool> condition, string what)
        => Assert.True(
            _kind.TryReach(Reactor, Board, condition), $"In {_kind} it never came so that {what}. {Describe()}");

    /// <summary>Lets a manager do something in a unit of work, waits for it, and throws here what it threw.</summary>
    public void On(ScriptedManager manager, Action action)
    {
        ScriptedManager.Job job = manager.Enqueue(action);
        manager.WakeUp();
        Until(() => job.IsDone, $"{manager.Name} does the job of the test");
        job.Rethrow();
    }

    /// <summary>
    /// As <see cref="On"/>, and waits until the unit of work has ended and the manager has nothing more to do.
    /// </summary>
    public void OnAndSettle(ScriptedManager manager, Action action)
    {
        On(manager, action);
        Until(() => StatusOf(manager).Runs == manager.Units, $"{manager.Name} ends its unit of work");
    }

    public ManagerStatus StatusOf(RabitManager manager)
    {
        MessageSubscriber<ManagerStatus> status = _statuses[manager];
        status.Fetch();
        return status.Value;
    }

    public ReactorResult Finish(string reason = "the test is over")
    {
        Reactor.Stop(reason);
        return _result = Reactor.Finish();
    }

    /// <summary>As <see cref="Finish"/>, where a manager is to stop the system.</summary>
    public ReactorResult FinishByItself() => _result = Reactor.Finish();

    public void Dispose()
    {
        if (!_hasStarted || _result is not null)
            return;
        Reactor.Stop("the test failed");
        Finish();   // the second stop: one that failed while a manager delays the first does not wait for it
    }

    private void Write(RabitLogEntry entry)
    {
        lock (Board.Gate)
            _log.Add(entry);
        Board.Changed();
    }

    private string Describe()
        => "Log:" + string.Concat(Log.Select(e => "\n" + e)) + "\nBoard: " + string.Join(", ", Board.Entries);
}
