using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 1.8: writers, with targets that do not block and so run in either time.</summary>
public abstract class WriterContract(TimeKind kind) : ContractTests(kind)
{
    [Fact, Trait("Clause", "1.8")]
    public void Writer_WhatTheManagerPushes_IsWrittenInOrder()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var target = new ScriptedTarget(run.Board);
        BlockingWriter<int> writer = manager.AttachWriter("radio", target);

        run.StartAndSettle();
        run.On(manager, () =>
        {
            for (int i = 1; i <= 5; i++)
                Assert.Equal(PushResult.Queued, writer.Push(i));
        });
        run.Until(() => target.Written.Count == 5, "all is written");
        run.Finish();

        Assert.Equal([1, 2, 3, 4, 5], target.Written);
        Assert.Equal(DeviceState.Stopped, writer.State);
        Assert.Equal(0, writer.Discarded);
    }

    [Fact, Trait("Clause", "1.8")]
    public void Writer_PushedInShutdown_IsWrittenBeforeItCloses()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var target = new ScriptedTarget(run.Board) { OnWrite = value => run.Board.Write("write " + value) };
        BlockingWriter<int> writer = manager.AttachWriter("radio", target);
        manager.OnShutdown = () =>
        {
            run.Board.Write("shutdown");
            writer.Push(1);
            writer.Push(2);
        };

        run.StartAndSettle();
        run.Until(() => run.Board.Count("open") == 1, "the writer opens its target");
        run.Finish();

        Assert.Equal(["open", "shutdown", "write 1", "write 2", "close"], run.Board.Entries);
        Assert.Equal(0, writer.Discarded);
    }

    [Fact, Trait("Clause", "1.8")]
    public void Writer_StoppedBeforeItsFirstTurn_WritesWhatWasPushedAllTheSame()
    {
        for (int seed = 0; seed < 20; seed++)
        {
            using TestRun run = NewRun(
                options => options.Time = Kind.HasThreads ? CreateTime() : new VirtualTime(seed));
            ScriptedManager manager = run.Add("m");
            var target = new ScriptedTarget(run.Board);
            BlockingWriter<int> writer = manager.AttachWriter("radio", target);
            manager.OnUnit = () =>
            {
                writer.Push(1);
                manager.StopAll("said all");
            };

            run.Start();
            run.FinishByItself();

            Assert.True(
                target.Written.Count == 1 && writer.Discarded == 0,
                $"seed {seed}: {target.Written.Count} written, {writer.Discarded} discarded");
            Assert.Equal(["open", "close"], run.Board.Entries);
        }
    }

    [Fact, Trait("Clause", "1.8")]
    public void Writer_StoppedBeforeTheBarrier_CountsWhatWasPushedAsDiscarded()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        BlockingWriter<int> writer = manager.AttachWriter("radio", new ScriptedTarget(run.Board));
        manager.OnStartup = () =>
        {
            writer.Push(1);
            manager.StopAll("changed its mind");
        };

        run.Start();
        run.FinishByItself();

        Assert.Empty(run.Board.Entries);
        Assert.Equal(1, writer.Discarded);
        Assert.Contains(run.Log, e => e.Source == "m/radio" && e.Kind == RabitLogKind.Note);
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "1.7")]
    public void Writer_TargetThatThrows_EndsFaultedAndWhatItDidNotWriteIsCounted()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var target = new ScriptedTarget(run.Board);
        target.OnWrite = value =>
        {
            if (value == 2)
                throw new InvalidOperationException("unplugged");
        };
        BlockingWriter<int> writer = manager.AttachWriter("radio", target);

        run.StartAndSettle();
        run.On(manager, () => Assert.Equal(4, Enumerable.Range(1, 4).Count(i => writer.Push(i) == PushResult.Queued)));
        run.Until(() => writer.State == DeviceState.Faulted, "the writer ends faulted");
        run.Until(() => manager.Causes.Any(c => (c & WakeUpCauses.Device) != 0), "its manager is woken");
        run.On(manager, () => writer.Push(5));
        Assert.Equal(0, run.Finish().ExitCode);

        // The one in hand when it threw, and the three that stayed in the queue.
        Assert.Equal([1], target.Written);
        Assert.Equal(4, writer.Discarded);
        Assert.Equal("unplugged", writer.Fault!.Message);
    }
}

public sealed class WriterInRealTime() : WriterContract(TimeKind.Real);

public sealed class WriterInVirtualTime() : WriterContract(TimeKind.Virtual);
