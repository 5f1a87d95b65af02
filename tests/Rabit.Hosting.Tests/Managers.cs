using System;
using System.Threading;
using Rabit.Core;

namespace Rabit.Hosting.Tests;

#pragma warning disable MA0048 // the small managers of these tests, side by side

/// <summary>What a manager takes from the container.</summary>
internal sealed class Journal
{
    private readonly object _gate = new();
    private string _text = string.Empty;

    public string Text
    {
        get
        {
            lock (_gate)
                return _text;
        }
    }

    public void Add(string word)
    {
        lock (_gate)
            _text += word + " ";
    }
}

internal struct Beat
{
    public int Number;
}

internal sealed class Source : RabitManager
{
    private readonly Journal _journal;
    private readonly MessagePublisher<Beat> _beat;

    public Source(Journal journal)
        : base("source")
    {
        _journal = journal;
        _beat = Publish<Beat>("beat");
        WakeUpDelay = TimeSpan.FromMilliseconds(5);
    }

    protected override void Startup() => _journal.Add("source-up");

    protected override void ExecuteUnitOfWork()
    {
        _beat.Value.Number++;
        _beat.Post();
    }

    protected override void Shutdown() => _journal.Add("source-down");
}

internal sealed class Sink : RabitManager, IDisposable
{
    private readonly Journal _journal;
    private readonly MessageSubscriber<Beat> _beat;

    public Sink(Journal journal)
        : base("sink")
    {
        _journal = journal;
        _beat = Subscribe<Beat>("beat", wakeOnPost: true);
    }

    public void Dispose() => _journal.Add("sink-disposed");

    protected override void Startup() => _journal.Add("sink-up");

    protected override void ExecuteUnitOfWork()
    {
        if (_beat.Fetch() && _beat.Value.Number == 1)
            Log("the first beat");
    }

    protected override void Shutdown() => _journal.Add("sink-down");
}

/// <summary>Does one thing, in its first unit of work.</summary>
internal sealed class Actor(string name, Action<Actor> act) : RabitManager(name)
{
    private bool _hasActed;

    public void End(string reason) => StopSystem(reason);

    protected override void ExecuteUnitOfWork()
    {
        if (_hasActed)
            return;
        _hasActed = true;
        act(this);
    }
}

/// <summary>Does not return from its unit of work until it is let go.</summary>
internal sealed class Stuck : RabitManager, IDisposable
{
    private readonly ManualResetEvent _go = new(initialState: false);

    public Stuck()
        : base("stuck")
    {
    }

    public ManualResetEvent Entered { get; } = new(initialState: false);

    /// <summary>How long it runs before that.</summary>
    public TimeSpan WaitsFor { get; init; }

    public void Release() => _go.Set();

    public void Dispose()
    {
        _go.Dispose();
        Entered.Dispose();
    }

    protected override void ExecuteUnitOfWork()
    {
        if (Now < WaitsFor)
        {
            WakeUpDelay = WaitsFor - Now;
            return;
        }

        Doing = "waiting for the test";
        Entered.Set();
        _go.WaitOne();
    }
}

internal sealed class Orphan : RabitManager
{
    public Orphan(string name)
        : base(name) => Subscribe<Beat>("beat of " + name);

    protected override void ExecuteUnitOfWork()
    {
    }
}

/// <summary>Misses deadlines in its first unit of work, none afterwards.</summary>
internal sealed class Late : RabitManager
{
    private bool _wasLate;

    public Late()
        : base("late") => Period = TimeSpan.FromSeconds(0.5);

    protected override void ExecuteUnitOfWork()
    {
        if (!_wasLate)
            Thread.Sleep(TimeSpan.FromSeconds(1.2));
        _wasLate = true;
    }
}
