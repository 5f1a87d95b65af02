using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>
/// Contract 1.8: readers and writers, with sources and targets that do not block and so run in either time.
/// </summary>
public abstract class DeviceContract(TimeKind kind) : ContractTests(kind)
{
    private static readonly TimeSpan AtOnce = TimeSpan.Zero;

    [Fact, Trait("Clause", "1.8")]
    public void Reader_SourceThatEnds_HandsOverAllInOrderAndWakesItsManager()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        BlockingReader<int> reader = manager.AttachReader(
            "line", new ScriptedSource(run.Board, TimeSpan.FromMilliseconds(2), 1, 2, 3));
        var got = new List<int>();
        manager.OnUnit = () => Drain(reader, got);

        run.StartAndSettle();
        run.Until(() => reader.State == DeviceState.Ended, "the reader ends");
        run.Until(() => manager.Causes.Any(c => (c & WakeUpCauses.Device) != 0), "its manager is woken");
        run.OnAndSettle(manager, () => { });
        run.Finish();

        Assert.Equal([1, 2, 3], got);
        Assert.Equal(["open", "close"], run.Board.Entries);
        Assert.Equal(DeviceState.Ended, reader.State);
        Assert.Null(reader.Fault);
        Assert.Equal(0, reader.Discarded);
        Assert.Contains(manager.Causes, cause => (cause & WakeUpCauses.Push) != 0);
    }

    [Fact, Trait("Clause", "1.8")]
    public void Reader_ValuesWithTimes_ComeNotBeforeThem()
    {
        var interval = TimeSpan.FromMilliseconds(10);
        var times = new List<TimeSpan>();
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        BlockingReader<int> reader = manager.AttachReader("line", new ScriptedSource(run.Board, interval, 1, 2, 3));
        manager.OnUnit = () =>
        {
            while (reader.TryPop(out _))
                times.Add(manager.Time);
        };

        run.Start();
        run.Until(() => reader.State == DeviceState.Ended, "the reader ends");
        run.OnAndSettle(manager, () => { });

        Assert.Equal(3, times.Count);
        Assert.True(times[2] - times[0] >= interval + interval - TimeSpan.FromMilliseconds(1) || Kind.HasThreads);
        if (!Kind.HasThreads)
            Assert.Equal(interval + interval, times[2] - times[0]);
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "3.1")]
    public void Reader_FullQueueThatWaits_HoldsTheReaderUpAndLosesNothing()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var source = new ScriptedSource(run.Board, AtOnce, Enumerable.Range(1, 20).ToArray());
        BlockingReader<int> reader = manager.AttachReader("line", source, capacity: 2);
        int next = 1;

        run.Start();
        run.Until(() => CountersOf(run, manager, reader).Resident == 2, "the queue is full");
        for (int i = 0; i < 20; i++)
        {
            run.Until(() => CountersOf(run, manager, reader).Resident > 0, "there is something to pop");
            run.On(manager, () =>
            {
                Assert.True(reader.TryPop(out int value));
                Assert.Equal(next++, value);
            });
        }

        run.Until(() => reader.State == DeviceState.Ended, "the reader ends");
        QueueCounters counters = CountersOf(run, manager, reader);
        Assert.Equal((20, 20, 0, 0), (counters.Pushed, counters.Popped, counters.Dropped, counters.Rejected));
        run.Finish();
        Assert.Equal(0, reader.Discarded);
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "3.1")]
    public void Reader_FullQueueThatDropsOldest_KeepsTheNewestAndCounts()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var source = new ScriptedSource(run.Board, AtOnce, Enumerable.Range(1, 100).ToArray());
        BlockingReader<int> reader = manager.AttachReader("line", source, capacity: 3, QueueFullMode.DropOldest);

        run.Start();
        run.Until(() => reader.State == DeviceState.Ended, "the reader ends");
        run.On(manager, () =>
        {
            Assert.Equal(97, reader.Counters.Dropped);
            Assert.True(reader.TryPop(out int value));
            Assert.Equal(98, value);
        });
    }

    [Fact, Trait("Clause", "1.8")]
    public void Reader_WaitsForSignal_ReadsAgainWhenSignalled()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var source = new ScriptedSource(run.Board, AtOnce) { AtTheEnd = ReaderStep.WaitForSignal };
        BlockingReader<int> reader = manager.AttachReader("line", source);
        var got = new List<int>();
        manager.OnUnit = () => Drain(reader, got);
        int reads = 0;
        source.OnRead = () =>
        {
            reads++;
            run.Board.Changed();
        };

        run.StartAndSettle();
        run.Until(() => reads > 0, "the source is asked once");
        source.Add(7);
        run.Until(() => manager.Causes.Any(c => (c & WakeUpCauses.Push) != 0), "the value wakes the manager");
        run.OnAndSettle(manager, () => { });
        run.Finish();

        Assert.Equal([7], got);
        Assert.Equal(DeviceState.Stopped, reader.State);
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "1.7")]
    public void Reader_SourceThatThrows_EndsFaultedAndHarmsNoOther()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var source = new ScriptedSource(run.Board, AtOnce, 1)
        {
            OnRead = () => throw new InvalidOperationException("unplugged")
        };
        BlockingReader<int> reader = manager.AttachReader("line", source);

        run.StartAndSettle();
        run.Until(() => reader.State == DeviceState.Faulted, "the reader ends faulted");
        run.Until(() => manager.Causes.Any(c => (c & WakeUpCauses.Device) != 0), "its manager is woken");
        Assert.Equal(0, run.Finish().ExitCode);

        Assert.Equal("unplugged", reader.Fault!.Message);
        RabitLogEntry entry = Assert.Single(run.Log, e => e.Kind == RabitLogKind.Fault);
        Assert.Equal("m/line", entry.Source);
        Assert.Equal(["open", "close"], run.Board.Entries);
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "1.7")]
    public void Reader_SourceThatCannotOpen_EndsFaultedAndIsClosed()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var source = new ScriptedSource(run.Board, AtOnce, 1)
        {
            OnOpen = () => throw new InvalidOperationException("no such line")
        };
        BlockingReader<int> reader = manager.AttachReader("line", source);

        run.Start();
        run.Until(() => reader.State == DeviceState.Faulted, "the reader ends faulted");
        run.Finish();

        Assert.Equal("no such line", reader.Fault!.Message);
        Assert.Equal(["open", "close"], run.Board.Entries);
    }

    [Fact, Trait("Clause", "1.8")]
    public void Reader_StoppedWithAValueInHand_CountsItAsDiscarded()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        BlockingReader<int> reader = manager.AttachReader(
            "line", new ScriptedSource(run.Board, AtOnce, 1, 2, 3), capacity: 1);

        run.Start();
        run.Until(() => CountersOf(run, manager, reader).Resident == 1, "the queue is full");
        run.Finish();

        Assert.Equal(1, reader.Discarded);
        Assert.Equal(DeviceState.Stopped, reader.State);
        Assert.Contains(run.Log, e => e.Source == "m/line" && e.Kind == RabitLogKind.Note);
    }

    [Fact, Trait("Clause", "1.8")]
    public void Reader_CloseThrows_TheValueInHandIsCountedAllTheSame()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var source = new ScriptedSource(run.Board, AtOnce, 1, 2, 3)
        {
            OnClose = () => throw new InvalidOperationException("stuck")
        };
        BlockingReader<int> reader = manager.AttachReader("line", source, capacity: 1);

        run.Start();
        run.Until(() => CountersOf(run, manager, reader).Resident == 1, "the queue is full");
        run.Finish();

        Assert.Equal(1, reader.Discarded);
        Assert.Contains(
            "stuck", Assert.Single(run.Log, e => e.Kind == RabitLogKind.Fault).Text, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "1.8")]
    public void Reader_Stop_EndsBeforeItsManagersShutdown()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.AttachReader("line", new ScriptedSource(run.Board, AtOnce) { AtTheEnd = ReaderStep.WaitForSignal });
        manager.OnShutdown = () => run.Board.Write("shutdown");

        run.StartAndSettle();
        run.Until(() => run.Board.Count("open") == 1, "the reader opens its source");
        run.Finish();

        Assert.Equal(["open", "close", "shutdown"], run.Board.Entries);
    }

    [Fact, Trait("Clause", "1.8")]
    public void Device_OpensWhenAllManagersHaveStarted()
    {
        using TestRun run = NewRun();
        ScriptedManager first = run.Add("first");
        ScriptedManager second = run.Add("second");
        first.AttachReader("line", new ScriptedSource(run.Board, AtOnce, 1));
        second.OnStartup = () => run.Board.Write("startup");

        run.Start();
        run.Until(() => run.Board.Count("open") == 1, "the reader opens its source");

        Assert.Equal(["startup", "open"], run.Board.Entries);
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "2.8")]
    public void Source_ThatTouchesItsManagersEnds_IsFaulted()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        MessageSubscriber<int> subscriber = manager.Subscribe<int>("height", optional: true);
        var source = new ScriptedSource(run.Board, AtOnce, 1) { OnRead = () => subscriber.Fetch() };
        BlockingReader<int> reader = manager.AttachReader("line", source);

        run.Start();
        run.Until(() => reader.State == DeviceState.Faulted, "the reader ends faulted");

        Assert.Contains("'height'", reader.Fault!.Message, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "4.2")]
    public void Device_TwoOfOneName_AreAWiringFault()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.AttachReader("line", new ScriptedSource(run.Board, AtOnce, 1));
        manager.AttachWriter("line", new ScriptedTarget(run.Board));

        Assert.Contains(
            Assert.Throws<RabitWiringException>(run.Start).Faults,
            fault => fault.Contains("'m/line' has 2 receivers", StringComparison.Ordinal));
    }

    private static void Drain(BlockingReader<int> reader, List<int> got)
    {
        while (reader.TryPop(out int value))
            got.Add(value);
    }

    private static QueueCounters CountersOf(TestRun run, ScriptedManager manager, BlockingReader<int> reader)
    {
        QueueCounters counters = default;
        run.On(manager, () => counters = reader.Counters);
        return counters;
    }
}

public sealed class DeviceInRealTime() : DeviceContract(TimeKind.Real);

public sealed class DeviceInVirtualTime() : DeviceContract(TimeKind.Virtual);
