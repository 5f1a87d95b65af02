using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Core.Tests.Contracts;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Devices;

/// <summary>
/// Units of work on readers (<see cref="RabitManager.RunsOnReaders"/>), with threads; every interleaving of the
/// hand-over itself is explored by <see cref="Exploration.LoanExplorationTests"/>.
/// </summary>
public sealed class RunsOnReadersTests : IDisposable
{
    private const string OnReader = "m/line";

    private readonly TestRun _run;
    private readonly ScriptedManager _manager;
    private readonly FedSource _source = new();
    private readonly BlockingReader<int> _reader;
    private readonly List<string?> _threads = [];   // of each unit of work; under the board's lock
    private int _fed;
    private int _popped;

    public RunsOnReadersTests()
    {
        _run = new TestRun(TimeKind.Real);
        _manager = _run.Add("m");
        _manager.RunsOnReaders = true;
        _reader = _manager.AttachReader("line", _source, 1000, QueueFullMode.DropOldest);
        _manager.OnUnit = PopAll;
    }

    private int UnitsOnReader
    {
        get
        {
            lock (_run.Board.Gate)
                return _threads.Count(t => t == OnReader);
        }
    }

    public void Dispose() => _run.Dispose();

    [Fact, Trait("Clause", "1.1"), Trait("Clause", "1.8")]
    public void UnitOfWork_ValueWhileTheManagerSleeps_RunsOnTheReadersThread()
    {
        _run.StartAndSettle();
        FeedUntilOnReader();
        ReactorResult result = _run.Finish();

        Assert.Equal(0, result.ExitCode);
        Assert.Contains(WakeUpCauses.Push, _manager.Causes);
        Assert.Equal(_manager.Units, result.Managers[0].Runs);
    }

    [Theory, Trait("Clause", "1.8")]
    [InlineData("not asked for")]
    [InlineData("period")]
    [InlineData("spin")]
    public void UnitOfWork_ManagerThatDoesNotLend_RunsOnItsOwnThread(string why)
    {
        const int Values = 30;
        _manager.RunsOnReaders = why != "not asked for";
        _manager.Period = why == "period" ? TimeSpan.FromHours(1) : null;
        _manager.SpinBeforeSleep = why == "spin" ? TimeSpan.FromTicks(10) : TimeSpan.Zero;
        _run.StartAndSettle();

        for (int i = 0; i < Values; i++)
            FeedOne();
        _run.Finish();

        Assert.Equal(0, UnitsOnReader);
    }

    [Fact, Trait("Clause", "1.3")]
    public void Timer_PutOffByUnitsOfWorkOnAReader_IsNeverEarly()
    {
        const int Values = 100;
        TimeSpan delay = TimeSpan.FromMilliseconds(20);
        TimeSpan lastEnd = TimeSpan.Zero;
        TimeSpan earliest = TimeSpan.MaxValue;
        _manager.WakeUpDelay = delay;
        _manager.OnUnit = () =>
        {
            if (_manager.CausesNow == WakeUpCauses.Timer && _manager.Time - lastEnd < earliest)
                earliest = _manager.Time - lastEnd;
            PopAll();
            lastEnd = _manager.Time;
        };
        _run.StartAndSettle();

        for (int i = 0; i < Values; i++)
            FeedOne();
        FeedUntilOnReader();
        _run.Until(() => _manager.Causes.Contains(WakeUpCauses.Timer), "the timer comes");
        _run.Finish();

        Assert.True(earliest >= delay, $"the timer came {earliest} after a unit of work");
    }

    [Fact, Trait("Clause", "1.3")]
    public void Timer_BroughtForwardByAUnitOfWorkOnAReader_Comes()
    {
        _manager.OnUnit = () =>
        {
            PopAll();
            if (Thread.CurrentThread.Name == OnReader)
                _manager.WakeUpDelay = TimeSpan.FromMilliseconds(1);
        };
        _run.StartAndSettle();

        FeedUntilOnReader();

        _run.Until(() => _manager.Causes.Contains(WakeUpCauses.Timer), "the timer comes");
        Assert.Equal(0, _run.Finish().ExitCode);
    }

    [Fact, Trait("Clause", "1.7")]
    public void Fault_OnAReader_CarriesOnAfterTheBackOffWithTheWakesThatCame()
    {
        TimeSpan backOff = TimeSpan.FromMilliseconds(30);
        TimeSpan? failedAt = null;
        TimeSpan? nextAt = null;
        _manager.FaultPolicy = FaultPolicy.CarryOnAfter(backOff, backOff);
        _manager.OnUnit = () =>
        {
            if (failedAt is not null)
                nextAt ??= _manager.Time;
            PopAll();
            if (failedAt is not null || Thread.CurrentThread.Name != OnReader)
                return;
            failedAt = _manager.Time;
            throw new InvalidOperationException("boom");
        };
        _run.StartAndSettle();

        FeedUntilOnReader();
        FeedOne();
        _run.Until(() => nextAt is not null, "it carries on");
        ReactorResult result = _run.Finish();

        Assert.Single(result.Managers[0].Faults);
        Assert.True(nextAt - failedAt >= backOff, $"it carried on after {nextAt - failedAt}");
    }

    [Fact, Trait("Clause", "1.7")]
    public void Fault_OnAReader_RestartsTheManager()
    {
        _manager.FaultPolicy = FaultPolicy.Restart;
        FailOnceOnReader();

        _run.Until(() => _manager.Startups == 2, "it starts up again");
        FeedUntilOnReader();
        ReactorResult result = _run.Finish();

        Assert.Equal((2, 1), (_manager.Shutdowns, result.Managers[0].Restarts));
    }

    [Fact, Trait("Clause", "1.7")]
    public void Fault_OnAReader_StopsTheManagerAlone()
    {
        _manager.FaultPolicy = FaultPolicy.StopManager;
        FailOnceOnReader();

        _run.Until(() => _manager.Shutdowns == 1, "it is stopped");
        _run.Finish();

        Assert.Equal(1, _manager.Shutdowns);
    }

    [Theory, Trait("Clause", "1.7"), Trait("Clause", "1.8")]
    [InlineData(false)]
    [InlineData(true)]
    public void Fault_OnAReader_IsFollowedUpOnTheManagersThread(bool restarts)
    {
        var threads = new ConcurrentQueue<string?>();
        _manager.WakeUpDelay = Timeout.InfiniteTimeSpan;
        _manager.FaultPolicy = restarts ? FaultPolicy.Restart : FaultPolicy.StopManager;
        _manager.OnStartup = () => threads.Enqueue(Thread.CurrentThread.Name);
        _manager.OnShutdown = () => threads.Enqueue(Thread.CurrentThread.Name);
        FailOnceOnReader();

        _run.Until(() => threads.Count == (restarts ? 3 : 2), "it is stopped, or starts up again");
        _run.Finish();

        Assert.Equal(restarts ? 4 : 2, threads.Count);
        Assert.All(threads, t => Assert.Equal("m", t));
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "1.4")]
    public void Fault_OnAReaderWithAWakeDuringIt_KeepsTheWake()
    {
        bool hasFailed = false;
        _manager.WakeUpDelay = Timeout.InfiniteTimeSpan;
        _manager.FaultPolicy = FaultPolicy.CarryOn;
        _manager.OnUnit = () =>
        {
            PopAll();
            if (hasFailed || Thread.CurrentThread.Name != OnReader)
                return;
            hasFailed = true;
            _manager.WakeUp();
            throw new InvalidOperationException("boom");
        };
        _run.StartAndSettle();

        FeedUntilOnReader();

        _run.Until(() => _manager.Causes.Any(c => (c & WakeUpCauses.Request) != 0), "the wake causes a unit of work");
        Assert.Single(_run.Finish().Managers[0].Faults);
    }

    [Fact, Trait("Clause", "1.4")]
    public void UnitOfWork_OnAReaderThatEndsTheLendingAndIsWoken_IsFollowedByAnotherAtOnce()
    {
        bool isLast = false;
        _manager.OnUnit = () =>
        {
            PopAll();
            if (isLast || Thread.CurrentThread.Name != OnReader)
                return;
            isLast = true;
            _manager.Period = TimeSpan.FromHours(1);
            _manager.WakeUp();
        };
        _run.StartAndSettle();

        FeedUntilOnReader();

        _run.Until(() => _manager.Causes.Any(c => (c & WakeUpCauses.Request) != 0), "the wake causes a unit of work");
        Assert.DoesNotContain(_manager.Causes, c => (c & WakeUpCauses.Timer) != 0);
    }

    [Fact, Trait("Clause", "1.7")]
    public void Fault_OnAReader_StopsTheSystem()
    {
        FailOnceOnReader();

        ReactorResult result = _run.FinishByItself();

        Assert.Equal((1, 1), (result.ExitCode, _manager.Shutdowns));
    }

    [Fact, Trait("Clause", "1.6")]
    public void Stop_DuringAUnitOfWorkOnAReader_WaitsForItsEnd()
    {
        using var isInside = new ManualResetEventSlim();
        using var mayEnd = new ManualResetEventSlim();
        bool hasEnded = false;
        bool shutDownLater = false;
        _manager.OnShutdown = () => shutDownLater = hasEnded;
        _manager.OnUnit = () =>
        {
            PopAll();
            if (Thread.CurrentThread.Name != OnReader)
                return;
            isInside.Set();
            mayEnd.Wait(TestTimeout.Limit);
            hasEnded = true;
        };
        _run.StartAndSettle();
        while (!isInside.IsSet)
        {
            _source.Feed(++_fed);
            isInside.Wait(20);
        }

        ReactorResult? result = null;
        var stopper = new Thread(() => result = _run.Finish());
        stopper.Start();
        mayEnd.Set();
        Assert.True(stopper.Join(TestTimeout.Limit));

        Assert.Equal((0, true), (result!.ExitCode, shutDownLater));
    }

    [Fact, Trait("Clause", "1.1"), Trait("Clause", "1.4")]
    public void UnitsOfWork_OnManyThreads_AreOneAtATimeAndSeeEachOther()
    {
        const int ValuesEach = 4000;
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager manager = run.Add("m");
        manager.RunsOnReaders = true;
        manager.WakeUpDelay = TimeSpan.FromMilliseconds(1);
        FedSource[] sources = [new(), new(), new()];
        BlockingReader<int>[] readers = sources
            .Select((s, i) => manager.AttachReader($"line {i}", s, 3 * ValuesEach, QueueFullMode.DropOldest)).ToArray();
        int[] last = new int[sources.Length];   // plain: the units of work hand it on to each other
        int inside = 0;
        int faults = 0;
        int popped = 0;
        manager.OnUnit = () =>
        {
            if (Interlocked.Increment(ref inside) != 1)
                Interlocked.Increment(ref faults);
            for (int i = 0; i < readers.Length; i++)
            {
                while (readers[i].TryPop(out int value))
                {
                    if (value != ++last[i])
                        Interlocked.Increment(ref faults);
                    popped++;
                }
            }

            Interlocked.Decrement(ref inside);
        };

        run.Start();
        Thread[] feeders = sources.Select(source => new Thread(() =>
        {
            for (int value = 1; value <= ValuesEach; value++)
            {
                source.Feed(value);
                if (value % 3 == 0)
                    Thread.Yield();
                if (value % 50 == 0)
                    manager.WakeUp();
            }
        })).ToArray();
        foreach (Thread feeder in feeders)
            feeder.Start();
        run.Until(() => Volatile.Read(ref popped) == ValuesEach * sources.Length, "all values are popped");
        foreach (Thread feeder in feeders)
            feeder.Join();
        ReactorResult result = run.Finish();

        Assert.Equal((0, 0), (faults, result.ExitCode));
    }

    [Fact, Trait("Clause", "1.8")]
    public void UnitOfWork_InVirtualTime_IsAStepOfTheManager()
    {
        using var run = new TestRun(TimeKind.Virtual);
        ScriptedManager manager = run.Add("m");
        manager.RunsOnReaders = true;
        BlockingReader<int> reader = manager.AttachReader(
            "line", new ScriptedSource(run.Board, TimeSpan.FromMilliseconds(2), 1, 2, 3), 10, QueueFullMode.DropOldest);
        var values = new List<int>();
        manager.OnUnit = () =>
        {
            while (reader.TryPop(out int value))
                values.Add(value);
        };

        run.Start();
        run.Until(() => values.Count == 3, "all values are popped");

        Assert.Equal([1, 2, 3], values);
    }

    private void FailOnceOnReader()
    {
        bool hasFailed = false;
        _manager.OnUnit = () =>
        {
            PopAll();
            if (hasFailed || Thread.CurrentThread.Name != OnReader)
                return;
            hasFailed = true;
            throw new InvalidOperationException("boom");
        };
        _run.StartAndSettle();
        FeedUntilOnReader();
    }

    // A manager that is not quite asleep yet is woken instead: another value, then.
    private void FeedUntilOnReader()
    {
        int before = UnitsOnReader;
        var timeout = new TestTimeout();
        while (UnitsOnReader == before)
        {
            _source.Feed(++_fed);
            Assert.True(timeout.TryWait(), "no unit of work ran on the reader's thread");
        }
    }

    private void FeedOne()
    {
        int value = ++_fed;
        _source.Feed(value);
        _run.Until(() => Volatile.Read(ref _popped) >= value, "the value is popped");
    }

    private void PopAll()
    {
        lock (_run.Board.Gate)
            _threads.Add(Thread.CurrentThread.Name);
        while (_reader.TryPop(out int value))
            Volatile.Write(ref _popped, value);
        _run.Board.Changed();
    }
}
