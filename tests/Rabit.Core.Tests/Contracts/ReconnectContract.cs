using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 1.8: readers and writers whose device fails and comes back.</summary>
public abstract class ReconnectContract(TimeKind kind) : ContractTests(kind)
{
    private static readonly ReconnectPolicy Quick = ReconnectPolicy.After(
        TimeSpan.FromMilliseconds(2), TimeSpan.FromMilliseconds(8));

    [Fact, Trait("Clause", "1.8")]
    public void Reader_SourceFailsOnce_IsOpenedAgainAndLosesNothing()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        int reads = 0;
        var source = new ScriptedSource(run.Board, TimeSpan.Zero, 1, 2, 3) { AtTheEnd = ReaderStep.WaitForSignal };
        source.OnRead = () =>
        {
            if (++reads == 2)
                throw new IOException("unplugged");
        };
        BlockingReader<int> reader = manager.AttachReader("line", source, reconnect: Quick);
        var got = new List<int>();
        manager.OnUnit = () =>
        {
            while (reader.TryPop(out int value))
                got.Add(value);
        };

        run.StartAndSettle();
        run.Until(() => reader.Reconnects == 1, "it is open again");
        run.Until(() => manager.Causes.Any(c => (c & WakeUpCauses.Device) != 0), "its manager is woken");
        run.OnAndSettle(manager, () => { });
        run.Until(() => reads >= 5, "all is read");
        run.OnAndSettle(manager, () => { });
        Assert.Equal(DeviceState.Running, reader.State);
        Assert.Equal(0, run.Finish().ExitCode);

        Assert.Equal([1, 2, 3], got);
        Assert.Equal(["open", "close", "open", "close"], run.Board.Entries);
        Assert.Equal((1, 1, 0), (reader.Faults, reader.Reconnects, reader.Discarded));
        Assert.Equal("unplugged", reader.Fault!.Message);
        Assert.Equal(DeviceState.Stopped, reader.State);
    }

    [Fact, Trait("Clause", "1.8")]
    public void Reader_SourceIsAway_BacksOffByDoublingAndReportsOnce()
    {
        var opens = new List<TimeSpan>();
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var source = new ScriptedSource(run.Board, TimeSpan.Zero, 1) { AtTheEnd = ReaderStep.WaitForSignal };
        source.OnOpen = () =>
        {
            opens.Add(manager.Time);
            if (opens.Count < 6)
                throw new IOException("no such line");
        };
        BlockingReader<int> reader = manager.AttachReader("line", source, reconnect: Quick);
        bool wasReconnecting = false;

        run.StartAndSettle();
        run.Until(
            () => (wasReconnecting |= reader.State == DeviceState.Reconnecting) && opens.Count == 6
                && reader.Reconnects == 1,
            "it is open again");
        TimeSpan since = reader.StateSince;
        run.Finish();

        double[] expected = [2, 4, 8, 8, 8];
        for (int i = 0; i < expected.Length; i++)
        {
            double gap = (opens[i + 1] - opens[i]).TotalMilliseconds;
            Assert.True(Kind.HasThreads ? gap >= expected[i] : gap == expected[i], $"attempt {i}: {gap} ms");
        }

        Assert.Equal(5, reader.Faults);
        Assert.True(since >= opens[5], $"{since} {opens[5]}");
        Assert.Single(run.Log, e => e.Kind == RabitLogKind.Fault);
        Assert.Single(
            run.Log, e => e.Kind == RabitLogKind.Lifecycle && e.Text.Contains("open again", StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "1.8")]
    public void Reader_MoreFailuresInARowThanAllowed_EndsFaulted()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var source = new ScriptedSource(run.Board, TimeSpan.Zero, 1)
        {
            OnRead = () => throw new IOException("unplugged")
        };
        BlockingReader<int> reader = manager.AttachReader(
            "line", source,
            reconnect: ReconnectPolicy.After(
                TimeSpan.FromMilliseconds(1), TimeSpan.FromMilliseconds(1), maxAttempts: 3));

        run.StartAndSettle();
        run.Until(() => reader.State == DeviceState.Faulted, "it gives up");
        run.Finish();

        Assert.Equal((4, 3), (reader.Faults, reader.Reconnects));
        Assert.Equal((4, 4), (run.Board.Count("open"), run.Board.Count("close")));
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "1.6")]
    public void Reader_StopDuringTheDelay_EndsAtOnce()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var source = new ScriptedSource(run.Board, TimeSpan.Zero, 1)
        {
            OnRead = () => throw new IOException("unplugged")
        };
        BlockingReader<int> reader = manager.AttachReader(
            "line", source, reconnect: ReconnectPolicy.After(TimeSpan.FromHours(1), TimeSpan.FromHours(1)));

        run.StartAndSettle();
        run.Until(() => reader.State == DeviceState.Reconnecting, "it waits");
        ReactorResult result = run.Finish();

        Assert.Equal(0, result.ExitCode);
        Assert.Equal(["open", "close"], run.Board.Entries);
        Assert.Equal(DeviceState.Stopped, reader.State);
    }

    [Fact, Trait("Clause", "1.8")]
    public void Writer_TargetFailsOnce_LosesTheValueInHandCountsItAndWritesTheRest()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        bool isBroken = true;
        var target = new ScriptedTarget(run.Board);
        target.OnWrite = value =>
        {
            if (value != 2 || !isBroken)
                return;
            isBroken = false;
            throw new IOException("unplugged");
        };
        BlockingWriter<int> writer = manager.AttachWriter("radio", target, reconnect: Quick);

        run.StartAndSettle();
        run.On(manager, () => Assert.Equal(4, Enumerable.Range(1, 4).Count(i => writer.Push(i) == PushResult.Queued)));
        run.Until(() => target.Written.Count == 3, "the rest is written");
        Assert.Equal(0, run.Finish().ExitCode);

        Assert.Equal([1, 3, 4], target.Written);
        Assert.Equal((1, 1, 1), (writer.Faults, writer.Reconnects, writer.Discarded));
    }

    /// <summary>A value that was written ends a row of failures: each of these is the first of its row.</summary>
    [Fact, Trait("Clause", "1.8")]
    public void Writer_FailsAgainAfterItHasWritten_IsOpenedAgainEachTime()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var broken = new HashSet<int> { 2, 4, 6 };
        var target = new ScriptedTarget(run.Board)
        {
            OnWrite = value =>
            {
                if (broken.Remove(value))
                    throw new IOException("unplugged");
            },
        };
        var quick = TimeSpan.FromMilliseconds(1);
        BlockingWriter<int> writer = manager.AttachWriter(
            "radio", target, reconnect: ReconnectPolicy.After(quick, quick, maxAttempts: 1));

        run.StartAndSettle();
        run.On(manager, () => Assert.Equal(7, Enumerable.Range(1, 7).Count(i => writer.Push(i) == PushResult.Queued)));
        run.Until(
            () => target.Written.Count == 4 || writer.State == DeviceState.Faulted, "the rest is written");
        run.Finish();

        Assert.Equal([1, 3, 5, 7], target.Written);
        Assert.Equal((3, 3, 3), (writer.Faults, writer.Reconnects, writer.Discarded));
    }

    [Fact, Trait("Clause", "1.8")]
    public void Writer_StoppedWhileItsTargetIsAway_CountsWhatIsLeft()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        var target = new ScriptedTarget(run.Board) { OnWrite = _ => throw new IOException("unplugged") };
        BlockingWriter<int> writer = manager.AttachWriter(
            "radio", target, reconnect: ReconnectPolicy.After(TimeSpan.FromHours(1), TimeSpan.FromHours(1)));

        run.StartAndSettle();
        run.On(manager, () => Assert.Equal(4, Enumerable.Range(1, 4).Count(i => writer.Push(i) == PushResult.Queued)));
        run.Until(() => writer.State == DeviceState.Reconnecting, "it waits");
        run.Finish();

        Assert.Equal(4, writer.Discarded);
        Assert.Contains(run.Log, e => e.Source == "m/radio" && e.Kind == RabitLogKind.Note);
    }

    [Fact, Trait("Clause", "1.8")]
    public void After_BadFigures_AreRefused()
    {
        TimeSpan one = TimeSpan.FromSeconds(1);
        Assert.Throws<ArgumentOutOfRangeException>(() => ReconnectPolicy.After(TimeSpan.Zero, one));
        Assert.Throws<ArgumentOutOfRangeException>(() => ReconnectPolicy.After(one + one, one));
        Assert.Throws<ArgumentOutOfRangeException>(() => ReconnectPolicy.After(one, one, maxAttempts: 0));
    }
}

public sealed class ReconnectInRealTime() : ReconnectContract(TimeKind.Real);

public sealed class ReconnectInVirtualTime() : ReconnectContract(TimeKind.Virtual);
