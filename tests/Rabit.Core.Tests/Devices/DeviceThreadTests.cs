using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Core.Tests.Contracts;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Devices;

/// <summary>Contract 1.8 with sources and targets that block their threads.</summary>
public sealed class DeviceThreadTests
{
    // Short for the one that hangs, long for the others, who must end within it on a busy machine.
    private static readonly TimeSpan ShortTimeout = TimeSpan.FromSeconds(1);

    [Fact, Trait("Clause", "1.8")]
    public void Reader_BlockedInRead_BlocksNoManagerAndEndsWhenUnblocked()
    {
        using var source = new BlockedSource();
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager manager = run.Add("m");
        BlockingReader<int> reader = manager.AttachReader("line", source);

        run.StartAndSettle();
        Assert.True(source.Blocked.Wait(TestTimeout.Limit));
        run.OnAndSettle(manager, () => { });
        ReactorResult result = run.Finish();

        Assert.Equal(0, result.ExitCode);
        Assert.Equal(1, source.Unblocks);
        Assert.Equal(DeviceState.Stopped, reader.State);
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "1.6")]
    public void Reader_ThatDoesNotUnblock_IsNamed()
    {
        using var source = new BlockedSource { IgnoresUnblock = true };
        using var run = new TestRun(TimeKind.Real, options => options.StopTimeout = ShortTimeout);
        ScriptedManager manager = run.Add("m");
        manager.AttachReader("line", source);

        run.StartAndSettle();
        Assert.True(source.Blocked.Wait(TestTimeout.Limit));
        ReactorResult result = run.Finish();
        source.Release();

        Assert.Equal(1, result.ExitCode);
        Assert.Equal("m/line: using its device", Assert.Single(result.Managers[0].NotStopped));
        Assert.Equal(1, manager.Shutdowns);
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "1.6")]
    public void Reader_ThatDoesNotUnblockWhileItOpensAgain_IsNamed()
    {
        using var source = new BlockedSource { IgnoresUnblock = true, BlocksInOpenAgain = true };
        using var run = new TestRun(TimeKind.Real, options => options.StopTimeout = ShortTimeout);
        run.Add("m").AttachReader(
            "line", source,
            reconnect: ReconnectPolicy.After(TimeSpan.FromMilliseconds(1), TimeSpan.FromMilliseconds(1)));

        run.StartAndSettle();
        Assert.True(source.Blocked.Wait(TestTimeout.Limit));
        ReactorResult result = run.Finish();
        source.Release();

        Assert.Equal("m/line: opening its device again", Assert.Single(result.Managers[0].NotStopped));
    }

    /// <summary>While the others run on: it would keep its device until the whole run stops.</summary>
    [Fact, Trait("Clause", "1.8"), Trait("Clause", "1.7")]
    public void Reader_OfAManagerThatIsStoppedAlone_IsUnblockedAtOnce()
    {
        using var source = new BlockedSource();
        using var run = new TestRun(TimeKind.Real);
        run.Add("other");
        ScriptedManager manager = run.Add("m");
        manager.FaultPolicy = FaultPolicy.StopManager;
        BlockingReader<int> reader = manager.AttachReader("line", source);
        manager.OnUnit = () =>
        {
            if (source.Blocked.IsSet)
                throw new InvalidOperationException("boom");
        };

        run.Start();
        Assert.True(source.Blocked.Wait(TestTimeout.Limit));
        manager.WakeUp();

        run.Until(() => reader.State == DeviceState.Stopped, "the reader ends");
        Assert.Equal(1, source.Unblocks);
        run.Finish();
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "1.6")]
    public void Reader_UnblockThrows_IsReportedAndAllAreStopped()
    {
        using var source = new BlockedSource { UnblockError = new InvalidOperationException("stuck") };
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager other = run.Add("other");
        run.Add("m").AttachReader("line", source);

        run.StartAndSettle();
        run.Finish();

        Assert.Equal(1, other.Shutdowns);
        Assert.Contains(run.Log, e => e.Kind == RabitLogKind.Fault && e.Source == "m/line"
            && e.Text.Contains("stuck", StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "3.1")]
    public void Reader_WaitsForRoom_GoesOnWhenTheManagerPops()
    {
        const int Values = 5000;
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager manager = run.Add("m");
        var source = new ScriptedSource(run.Board, TimeSpan.Zero, Enumerable.Range(0, Values).ToArray());
        BlockingReader<int> reader = manager.AttachReader("line", source, capacity: 3);
        int next = 0;
        manager.OnUnit = () =>
        {
            while (reader.TryPop(out int value))
                Assert.Equal(next++, value);
            run.Board.Changed();
        };

        run.Start();
        run.Until(() => Volatile.Read(ref next) == Values, "all values come through");
        ReactorResult result = run.Finish();

        Assert.Equal(0, result.ExitCode);
        Assert.Equal(0, reader.Discarded);
    }

    [Fact, Trait("Clause", "1.8")]
    public void Writer_BlockedInWrite_HoldsItsManagerNotUpAndDrainsAtTheStop()
    {
        using var target = new BlockedTarget();
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager manager = run.Add("m");
        BlockingWriter<int> writer = manager.AttachWriter("radio", target);

        run.StartAndSettle();
        run.On(manager, () => Push(writer, 3));
        Assert.True(target.Blocked.Wait(TestTimeout.Limit));
        run.OnAndSettle(manager, () => Push(writer, 2));

        // The writer goes on only when its manager has shut down: what is left is written during the stop.
        manager.OnShutdown = target.Release;
        ReactorResult result = run.Finish();

        Assert.Equal(0, result.ExitCode);
        Assert.Equal([0, 1, 2, 0, 1], target.Written);
        Assert.Equal(0, target.Unblocks);
        Assert.Equal(0, writer.Discarded);
        Assert.Equal(DeviceState.Stopped, writer.State);
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "1.6")]
    public void Writer_StillBlockedWhenItsTimeIsUp_IsUnblockedAndCountsTheRestAsDiscarded()
    {
        using var target = new BlockedTarget();
        using var run = new TestRun(TimeKind.Real, options => options.StopTimeout = ShortTimeout);
        ScriptedManager manager = run.Add("m");
        BlockingWriter<int> writer = manager.AttachWriter("radio", target);

        run.StartAndSettle();
        run.OnAndSettle(manager, () => Push(writer, 4));
        Assert.True(target.Blocked.Wait(TestTimeout.Limit));
        ReactorResult result = run.Finish();

        Assert.Equal(ManagerOutcome.Ended, result.Managers[0].Outcome);
        Assert.Equal(1, target.Unblocks);
        Assert.Equal([0], target.Written);
        Assert.Equal(3, writer.Discarded);
    }

    private static void Push(BlockingWriter<int> writer, int count)
    {
        for (int i = 0; i < count; i++)
            Assert.Equal(PushResult.Queued, writer.Push(i));
    }

    /// <summary>A source whose every read blocks until it is unblocked.</summary>
    private sealed class BlockedSource : IReaderSource<int>, IDisposable
    {
        private readonly ManualResetEventSlim _release = new();
        private int _opened;   // the reader's thread

        public ManualResetEventSlim Blocked { get; } = new();

        public bool IgnoresUnblock { get; init; }

        public Exception? UnblockError { get; init; }

        /// <summary>The first read fails, and it is the second opening that blocks.</summary>
        public bool BlocksInOpenAgain { get; init; }

        public int Unblocks { get; private set; }

        public bool Blocks => true;

        public void Open(ReaderContext context)
        {
            if (!BlocksInOpenAgain || _opened++ == 0)
                return;
            Blocked.Set();
            _release.Wait();
        }

        public ReaderStep Read(out int value)
        {
            value = 0;
            if (BlocksInOpenAgain)
                throw new System.IO.IOException("unplugged");
            Blocked.Set();
            _release.Wait();
            return ReaderStep.WaitForSignal;
        }

        public void Unblock()
        {
            Unblocks++;
            if (!IgnoresUnblock)
                _release.Set();
            if (UnblockError is { } error)
                throw error;
        }

        public void Release() => _release.Set();

        public void Close()
        {
        }

        public void Dispose() => Release();
    }

    /// <summary>A target whose every write blocks until it is released or unblocked.</summary>
    private sealed class BlockedTarget : IWriterTarget<int>, IDisposable
    {
        private readonly ManualResetEventSlim _release = new();
        private readonly List<int> _written = [];

        public ManualResetEventSlim Blocked { get; } = new();

        public int Unblocks { get; private set; }

        public IReadOnlyList<int> Written => _written;

        public bool Blocks => true;

        public void Open()
        {
        }

        public void Write(in int value)
        {
            Blocked.Set();
            _release.Wait();
            _written.Add(value);
        }

        public void Unblock()
        {
            Unblocks++;
            _release.Set();
        }

        public void Release() => _release.Set();

        public void Close()
        {
        }

        public void Dispose() => Release();
    }
}
