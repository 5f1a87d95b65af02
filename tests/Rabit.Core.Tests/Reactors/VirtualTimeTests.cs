using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Reactors;

/// <summary>Contract 5.2: what only virtual time promises.</summary>
public sealed class VirtualTimeTests
{
    [Fact, Trait("Clause", "5.2")]
    public void Clock_ByDefault_StartsInTheYear2000AndMovesOnlyWithTheRun()
    {
        var time = new VirtualTime();
        using TestRun run = NewRun(time);
        run.Add("m");

        run.Start();
        run.Reactor.RunFor(TimeSpan.FromHours(2));

        Assert.Equal(TimeSpan.FromHours(2), run.Reactor.Now);
        Assert.Equal(new DateTimeOffset(2000, 1, 1, 2, 0, 0, TimeSpan.Zero), time.Clock.GetUtcNow());
        Assert.Equal(TimeZoneInfo.Utc, time.Clock.LocalTimeZone);
    }

    [Fact, Trait("Clause", "5.2")]
    public void Clock_WithAStart_HasThatWallTime()
    {
        var start = new DateTimeOffset(2024, 5, 6, 7, 8, 9, TimeSpan.Zero);
        Assert.Equal(start, new VirtualTime(seed: 3, start).Clock.GetUtcNow());
    }

    [Fact]
    public void Clock_WithAStartOfAnotherOffset_IsInUtc()
    {
        var start = new DateTimeOffset(2024, 5, 6, 7, 8, 9, TimeSpan.FromHours(2));
        DateTimeOffset now = new VirtualTime(seed: 3, start).Clock.GetUtcNow();

        Assert.Equal((TimeSpan.Zero, start), (now.Offset, now));
    }

    [Fact]
    public void StepWallClock_InARun_MovesTheWallClockAlone()
    {
        var time = new VirtualTime();
        using TestRun run = NewRun(time);
        run.Add("m");
        run.Start();
        run.Reactor.RunFor(TimeSpan.FromHours(1));
        time.StepWallClock(TimeSpan.FromDays(-400));
        time.StepWallClock(TimeSpan.FromMinutes(1));
        run.Reactor.RunFor(TimeSpan.FromHours(1));

        Assert.Equal(TimeSpan.FromHours(2), run.Reactor.Now);
        Assert.Equal(TimeSpan.FromHours(2).Ticks, time.Clock.GetTimestamp());
        Assert.Equal(
            new DateTimeOffset(2000, 1, 1, 2, 1, 0, TimeSpan.Zero).AddDays(-400), time.Clock.GetUtcNow());
        Assert.Throws<ArgumentOutOfRangeException>(() => time.StepWallClock(TimeSpan.FromDays(-900_000)));
        Assert.Equal(1998, time.Clock.GetUtcNow().Year);
    }

    [Fact, Trait("Clause", "5.2")]
    public void Timers_OfTheClock_AreRefused()
        => Assert.Throws<NotSupportedException>(
            () => new VirtualTime().Clock.CreateTimer(_ => { }, null, TimeSpan.Zero, TimeSpan.Zero));

    [Fact, Trait("Clause", "5.2")]
    public void RunFor_Steps_RunsWhatIsDueInEachAndNothingElse()
    {
        using TestRun run = NewRun(new VirtualTime());
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.FromMilliseconds(10);

        run.Start();
        Assert.Equal(0, manager.Units);
        var units = new List<int>();
        foreach (int milliseconds in new[] { 0, 9, 1, 5, 5, 30, 0 })
        {
            Assert.True(run.Reactor.RunFor(TimeSpan.FromMilliseconds(milliseconds)));
            units.Add(manager.Units);
        }

        Assert.Equal([1, 1, 2, 2, 3, 6, 6], units);
    }

    [Fact, Trait("Clause", "5.2")]
    public void Steps_OfAllManagers_AreTakenOnTheThreadThatRuns()
    {
        var threads = new HashSet<int>();
        using TestRun run = NewRun(new VirtualTime());
        foreach (string name in new[] { "a", "b" })
            run.Add(name).OnUnit = () => threads.Add(Environment.CurrentManagedThreadId);

        run.Start();
        run.Reactor.RunFor(TimeSpan.FromHours(2));

        Assert.Equal(Environment.CurrentManagedThreadId, Assert.Single(threads));
    }

    [Fact, Trait("Clause", "5.2")]
    public void Finish_RunThatIsNeverStopped_EndsItWithAnErrorAtItsLimit()
    {
        using TestRun run = NewRun(new VirtualTime { MaxDuration = TimeSpan.FromHours(5) });
        run.Add("m");

        run.Start();
        run.Reactor.RunFor(TimeSpan.FromHours(30));   // has its own limit
        ReactorResult result = run.FinishByItself();

        Assert.Equal(1, result.ExitCode);
        Assert.Contains("05:00:00", result.Failure!.Message, StringComparison.Ordinal);
        Assert.Contains("MaxDuration", result.Failure.Message, StringComparison.Ordinal);
        Assert.InRange(result.Duration, TimeSpan.FromHours(34), TimeSpan.FromHours(35));
    }

    [Fact, Trait("Clause", "5.2")]
    public void MaxDuration_ByDefault_IsADay()
    {
        using TestRun run = NewRun(new VirtualTime());
        ScriptedManager manager = run.Add("m");
        manager.OnUnit = () =>
        {
            if (manager.Time >= TimeSpan.FromHours(23))
                manager.StopAll("done");
        };
        run.Start();
        Assert.Equal(0, run.FinishByItself().ExitCode);

        Assert.Equal(TimeSpan.FromDays(1), new VirtualTime().MaxDuration);
    }

    [Fact, Trait("Clause", "5.2")]
    public void Settings_OutOfRange_AreRefused()
    {
        var time = new VirtualTime();
        Assert.Throws<ArgumentOutOfRangeException>(() => time.Pace = 0);
        Assert.Throws<ArgumentOutOfRangeException>(() => time.Pace = double.NaN);
        Assert.Throws<ArgumentOutOfRangeException>(() => time.MaxRunsPerInstant = 0);
        Assert.Throws<ArgumentOutOfRangeException>(() => time.MaxDuration = TimeSpan.Zero);
        var error = Assert.Throws<ArgumentOutOfRangeException>(
            () => time.SetUnitOfWorkDuration("slow", TimeSpan.FromTicks(-1)));
        Assert.Contains("'slow'", error.Message, StringComparison.Ordinal);
        error = Assert.Throws<ArgumentOutOfRangeException>(
            () => time.SetUnitOfWorkDuration("slow", TimeSpan.FromTicks(2), TimeSpan.FromTicks(1)));
        Assert.Contains("'slow'", error.Message, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "5.2")]
    public void VirtualTime_OfTwoReactors_IsRefused()
    {
        var time = new VirtualTime();
        _ = new RabitReactor(time);
        Assert.Throws<InvalidOperationException>(() => new RabitReactor(time));
    }

    [Fact, Trait("Clause", "5.2")]
    public void StandStill_TwoThatWakeEachOther_StopsWithAnErrorThatNamesThem()
    {
        using TestRun run = NewRun(new VirtualTime { MaxRunsPerInstant = 500 });
        ScriptedManager ping = run.Add("ping");
        ScriptedManager pong = run.Add("pong");
        ScriptedManager innocent = run.Add("innocent");
        ping.OnUnit = pong.WakeUp;
        pong.OnUnit = ping.WakeUp;

        run.Start();
        Assert.False(run.Reactor.RunFor(TimeSpan.FromSeconds(1)));
        ReactorResult result = run.FinishByItself();

        string text = Assert.IsType<InvalidOperationException>(result.Failure).Message;
        Assert.Equal(1, result.ExitCode);
        Assert.Contains("ping (", text, StringComparison.Ordinal);
        Assert.Contains("pong (", text, StringComparison.Ordinal);
        Assert.DoesNotContain("innocent", text, StringComparison.Ordinal);
        Assert.Contains("500", text, StringComparison.Ordinal);
        Assert.InRange(ping.Units + pong.Units + innocent.Units, 400, 500);
        Assert.Equal(3, ping.Shutdowns + pong.Shutdowns + innocent.Shutdowns);
    }

    [Fact, Trait("Clause", "5.2")]
    public void StandStill_ManyRunsButTheClockMoves_IsNone()
    {
        using TestRun run = NewRun(new VirtualTime { MaxRunsPerInstant = 3 });
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.FromTicks(1);

        run.Start();

        Assert.True(run.Reactor.RunFor(TimeSpan.FromTicks(1000)));
        Assert.Equal(1001, manager.Units);
    }

    [Theory, Trait("Clause", "5.2"), Trait("Clause", "1.8")]
    [InlineData(true)]
    [InlineData(false)]
    public void BlockingDevice_InVirtualTime_IsRefusedByName(bool reader)
    {
        using TestRun run = NewRun(new VirtualTime());
        ScriptedManager manager = run.Add("m");
        if (reader)
            manager.AttachReader("line", new BlockingDevice());
        else
            manager.AttachWriter("line", new BlockingDevice());

        Assert.Contains(
            "'m/line'", Assert.Single(Assert.Throws<RabitWiringException>(run.Start).Faults), StringComparison.Ordinal);
    }

    [Theory, Trait("Clause", "5.2")]
    [InlineData(true)]
    [InlineData(false)]
    public void Pace_SetBeforeOrAfterTheReactorIsMade_HoldsVirtualTimeBack(bool before)
    {
        var time = new VirtualTime();
        if (before)
            time.Pace = 20;
        using TestRun run = NewRun(time);
        if (!before)
            time.Pace = 20;
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.FromMilliseconds(100);

        run.Start();
        var real = Stopwatch.StartNew();
        run.Reactor.RunFor(TimeSpan.FromSeconds(2));

        Assert.Equal(21, manager.Units);
        Assert.True(real.Elapsed >= TimeSpan.FromMilliseconds(80), $"two virtual seconds took {real.Elapsed}");
    }

    [Fact, Trait("Clause", "5.2"), Trait("Clause", "4.4")]
    public void Pace_WakeFromAnotherThread_IsTakenBetweenStepsAndWithoutLatency()
    {
        using var isPacing = new ManualResetEventSlim();
        using TestRun run = NewRun(new VirtualTime { Pace = 10 });
        ScriptedManager manager = run.Add("m");
        bool isWoken = false;
        manager.OnUnit = () =>
        {
            // A wake that comes before the run has gone to sleep finds the time where it was; another one follows.
            if (run.Reactor.Now > TimeSpan.Zero)
            {
                manager.StopAll("woken");
                Volatile.Write(ref isWoken, true);
            }

            isPacing.Set();
        };
        var outside = new Thread(() =>
        {
            isPacing.Wait();
            while (!Volatile.Read(ref isWoken))
            {
                var held = Stopwatch.StartNew();
                while (held.ElapsedMilliseconds < 60)
                    Thread.SpinWait(100);
                manager.WakeUp();
            }
        });

        run.Start();
        outside.Start();
        Assert.False(run.Reactor.RunFor(TimeSpan.FromHours(1)));
        run.FinishByItself();
        outside.Join();

        Assert.Equal(WakeUpCauses.Start, manager.Causes[0]);
        Assert.NotEmpty(manager.Causes.Skip(1));
        Assert.All(manager.Causes.Skip(1), causes => Assert.Equal(WakeUpCauses.Request, causes));
        Assert.InRange(run.Reactor.Now, TimeSpan.FromTicks(1), TimeSpan.FromHours(1) - TimeSpan.FromTicks(1));
        Assert.Equal(TimeSpan.Zero, run.StatusOf(manager).WakeLatency.Max);
    }

    [Fact, Trait("Clause", "5.2")]
    public void OtherThreads_ThatPushWhileItRuns_LoseNothing()
    {
        const int Each = 20_000;
        using TestRun run = NewRun(new VirtualTime { MaxRunsPerInstant = int.MaxValue });
        ScriptedManager sink = run.Add("sink");
        ScriptedManager ticker = run.Add("ticker");
        ticker.WakeUpDelay = TimeSpan.FromMilliseconds(1);
        QueueReceiver<int> receiver = sink.Receive<int>("queue", capacity: 2 * Each);
        int got = 0;
        sink.OnUnit = () =>
        {
            while (receiver.TryPop(out _))
                got++;
            if (got == 2 * Each)
                sink.StopAll("all there");
        };
        var threads = new List<Thread>();
        for (int i = 0; i < 2; i++)
        {
            QueueSender<int> sender = run.Reactor.Workspace.Send<int>("queue");
            threads.Add(new Thread(() =>
            {
                for (int n = 0; n < Each; n++)
                    sender.Push(n);
            }));
        }

        run.Start();
        threads.ForEach(t => t.Start());
        Assert.False(run.Reactor.RunFor(TimeSpan.FromDays(10_000)));
        Assert.Equal("sink: all there", run.FinishByItself().StopReason);
        threads.ForEach(t => t.Join());
    }

    [Fact, Trait("Clause", "5.2"), Trait("Clause", "4.4")]
    public void RealTurnTime_OfAManager_IsMeasuredBesideTheVirtualOne()
    {
        using TestRun run = NewRun(new VirtualTime());
        ScriptedManager manager = run.Add("m");
        manager.OnUnit = () => Thread.SpinWait(1000);

        run.Start();
        run.Reactor.RunFor(TimeSpan.FromHours(3));

        Assert.Equal(manager.Units, run.Reactor.RealStepTime("m").Count);
        Assert.True(run.Reactor.RealStepTime("m").Total > TimeSpan.Zero);
        Assert.Equal(TimeSpan.Zero, run.StatusOf(manager).UnitOfWorkTime.Total);
        Assert.Contains(
            "'ghost'", Assert.Throws<ArgumentException>(() => run.Reactor.RealStepTime("ghost")).Message,
            StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "4.4")]
    public void RealStepTime_OfAMistypedName_SuggestsTheOneThatWasMeant()
    {
        using TestRun run = NewRun(new VirtualTime());
        run.Add("navigation");
        string TextFor(string name)
            => Assert.Throws<ArgumentException>(() => run.Reactor.RealStepTime(name)).Message;

        Assert.DoesNotContain("Did you mean", TextFor("navigaton"), StringComparison.Ordinal);   // none has started
        run.Start();

        Assert.StartsWith(
            "No manager 'navigaton' has started. Did you mean 'navigation'?", TextFor("navigaton"),
            StringComparison.Ordinal);
        Assert.DoesNotContain("Did you mean", TextFor("ghost"), StringComparison.Ordinal);
    }

    private static TestRun NewRun(VirtualTime time) => new(TimeKind.Virtual, options => options.Time = time);

    private sealed class BlockingDevice : IReaderSource<int>, IWriterTarget<int>
    {
        public bool Blocks => true;

        public void Open(ReaderContext context)
        {
        }

        public void Open()
        {
        }

        public ReaderStep Read(out int value)
        {
            value = 0;
            return ReaderStep.Ended;
        }

        public void Write(in int value)
        {
        }

        public void Unblock()
        {
        }

        public void Close()
        {
        }
    }
}
