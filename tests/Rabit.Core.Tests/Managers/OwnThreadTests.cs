using System;
using System.Linq;
using System.Threading;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Managers;

/// <summary>Contract 1.1 and 1.8 where they speak of threads.</summary>
public sealed class OwnThreadTests
{
    [Fact, Trait("Clause", "1.1")]
    public void Manager_AllItsLife_RunsOnOneThreadOfItsOwnThatBearsItsName()
    {
        using var run = new TestRun(TimeKind.Real);
        foreach (string name in new[] { "a", "b" })
        {
            ScriptedManager manager = run.Add(name);
            void WriteThread()
                => run.Board.Write($"{name} {Thread.CurrentThread.Name} {Environment.CurrentManagedThreadId}");
            manager.OnStartup = WriteThread;
            manager.OnUnit = WriteThread;
            manager.OnShutdown = WriteThread;
        }

        run.StartAndSettle();
        run.Finish();

        string[] distinct = run.Board.Entries.Distinct(StringComparer.Ordinal)
            .OrderBy(e => e, StringComparer.Ordinal).ToArray();
        Assert.Equal(6, run.Board.Entries.Count);
        Assert.Equal(2, distinct.Length);
        Assert.StartsWith("a a ", distinct[0], StringComparison.Ordinal);
        Assert.StartsWith("b b ", distinct[1], StringComparison.Ordinal);
        Assert.NotEqual(distinct[0].Substring(4), distinct[1].Substring(4));
        Assert.DoesNotContain(
            distinct, e => e.EndsWith(" " + Environment.CurrentManagedThreadId, StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "1.8")]
    public void Reader_AllItsLife_RunsOnAThreadOfItsOwnThatBearsItsName()
    {
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager manager = run.Add("m");
        void WriteThread() => run.Board.Write(Thread.CurrentThread.Name + " " + Environment.CurrentManagedThreadId);
        var source = new ScriptedSource(new TestBoard(), TimeSpan.Zero, 1)
        {
            OnOpen = WriteThread,
            OnRead = WriteThread,
            OnClose = WriteThread
        };
        manager.AttachReader("line", source);

        run.Start();
        run.Until(() => run.Board.Entries.Count >= 2, "the source is read");
        run.Finish();

        Assert.StartsWith(
            "m/line ", Assert.Single(run.Board.Entries.Distinct(StringComparer.Ordinal)), StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "1.2")]
    public void Sleep_UntilTheTimer_NeitherPollsNorSpins()
    {
        const int Units = 20;
        var clock = new CountingClock();
        using var run = new TestRun(TimeKind.Real, options => options.Time = new RealTime(clock));
        ScriptedManager manager = run.Add("m");
        manager.OnStartup = () => clock.Counted = Thread.CurrentThread;

        // Not whole milliseconds, in which the system's waits are counted.
        manager.WakeUpDelay = TimeSpan.FromTicks((5 * TimeSpan.TicksPerMillisecond) + 4321);

        run.Start();
        run.Until(() => manager.Units >= Units, "the timer wakes it");
        run.Finish();

        // A wait reads the clock before and after: a handful of reads for each unit, not thousands.
        Assert.True(clock.Reads < 20 * manager.Units, $"{clock.Reads} reads of the clock in {manager.Units} units");
    }

    private sealed class CountingClock : TimeProvider
    {
        private long _reads;

        public Thread? Counted { get; set; }

        public long Reads => Interlocked.Read(ref _reads);

        public override long GetTimestamp()
        {
            if (Thread.CurrentThread == Counted)
                Interlocked.Increment(ref _reads);
            return base.GetTimestamp();
        }
    }
}
