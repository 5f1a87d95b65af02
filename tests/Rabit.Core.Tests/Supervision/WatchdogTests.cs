using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Core.Tests.Contracts;
using Rabit.Core.Tests.Time;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Supervision;

/// <summary>Contract 4.5 in real time: code that really does not come back.</summary>
public sealed class WatchdogTests
{
    // The clock of the run stands still but for these steps, so that no machine is too slow for the limits.
    private static readonly TimeSpan PastTheLimit = TimeSpan.FromMilliseconds(25);

    private static readonly HangPolicy Soon = HangPolicy.Report.WithLimits(
        TimeSpan.FromMilliseconds(20), TimeSpan.FromMilliseconds(20), TimeSpan.FromMilliseconds(20));

    [Theory, Trait("Clause", "4.5")]
    [InlineData(ManagerStage.Startup)]
    [InlineData(ManagerStage.UnitOfWork)]
    [InlineData(ManagerStage.Shutdown)]
    public void Manager_ThatHangs_IsFoundInLogStatusAndResult(ManagerStage stage)
    {
        using var found = new ManualResetEventSlim();
        var hangs = new List<ManagerHang>();
        var clock = new ManualClock();
        using TestRun run = NewRun(clock, Soon.AndCall(hang =>
        {
            hangs.Add(hang);
            found.Set();
        }));
        ScriptedManager manager = run.Add("m");
        run.Add("other");
        ManagerStatus seen = default;
        Hang(manager, stage, () =>
        {
            manager.Doing = "asking the camera";
            clock.Timestamp += PastTheLimit.Ticks;
            Assert.True(found.Wait(TestTimeout.Limit));
            MessageSubscriber<ManagerStatus> status = run.Reactor.Workspace.SubscribeToStatus("m");
            status.Fetch();
            seen = status.Value;
        }, unit: 2);   // the other manager sleeps then

        run.StartAndSettle();
        run.OnAndSettle(manager, () => { });
        ReactorResult result = run.Finish();

        ManagerHang hang = Assert.Single(hangs);
        Assert.Equal(("m", stage, "asking the camera"), (hang.Manager, hang.Stage, hang.Doing));
        Assert.InRange(hang.Duration, TimeSpan.FromMilliseconds(20), TestTimeout.Limit);
        Assert.Equal((ManagerState.Hanging, 1, hang.Since), (seen.State, seen.Hangs, seen.HangingSince));
        Assert.Contains("asking the camera", seen.LastHang, StringComparison.Ordinal);

        ManagerResult ended = result.Managers[0];
        Assert.Equal((ManagerOutcome.Ended, 1, 0), (ended.Outcome, ended.HangCount, result.Managers[1].HangCount));
        Assert.Same(hang, Assert.Single(ended.Hangs));
        Assert.Contains("hangs in " + stage, ended.ToString(), StringComparison.Ordinal);
        Assert.Equal(0, result.ExitCode);
        Assert.Equal(
            (ManagerState.Stopped, 1, TimeSpan.Zero),
            (ended.Status.State, ended.Status.Hangs, ended.Status.HangingSince));
        Assert.Equal(2, run.Log.Count(e => e.Kind == RabitLogKind.Hang && e.Source == "m"));
    }

    [Theory, Trait("Clause", "4.5"), Trait("Clause", "1.6")]
    [InlineData(ManagerStage.Startup)]
    [InlineData(ManagerStage.UnitOfWork)]
    public void Manager_ThatNeverComesBack_StopsTheSystemAndIsNamed(ManagerStage stage)
    {
        using var release = new ManualResetEventSlim();
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager other = run.Add("other");
        ScriptedManager manager = run.Add("m");
        manager.HangPolicy = Soon.AndStopSystem();
        manager.StopTimeout = TimeSpan.FromMilliseconds(100);
        Hang(manager, stage, () =>
        {
            manager.Doing = "waiting for a lock";
            release.Wait();
        });

        run.Start();
        ReactorResult result = run.FinishByItself();
        release.Set();

        Assert.Contains("m hangs in " + stage, result.StopReason, StringComparison.Ordinal);
        Assert.Equal(ManagerOutcome.DidNotStop, result.Managers[1].Outcome);
        Assert.Contains(": waiting for a lock", Assert.Single(result.Managers[1].NotStopped), StringComparison.Ordinal);
        Assert.Equal(ManagerState.Hanging, result.Managers[1].Status.State);
        Assert.Equal(1, other.Shutdowns);
        Assert.Equal(1, result.ExitCode);
    }

    [Fact, Trait("Clause", "4.5")]
    public void Manager_BackFromAHang_PostsThatItRunsAfterTheWatchdogsStatus()
    {
        const int Rounds = 30;
        using var found = new AutoResetEvent(false);
        var clock = new ManualClock();
        using TestRun run = NewRun(clock, Soon.AndCall(_ => found.Set()));
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        for (int round = 1; round <= Rounds; round++)
        {
            // It comes back while the watchdog has just posted, or is about to.
            run.OnAndSettle(manager, () =>
            {
                clock.Timestamp += PastTheLimit.Ticks;
                Assert.True(found.WaitOne(TestTimeout.Limit));
            });
            ManagerStatus status = run.StatusOf(manager);
            Assert.Equal((ManagerState.Running, (long)round), (status.State, status.Hangs));
        }
    }

    [Fact, Trait("Clause", "4.5")]
    public void Callback_ThatThrows_IsReportedAndTheWatchdogGoesOn()
    {
        using var found = new AutoResetEvent(false);
        using var run = new TestRun(TimeKind.Real, options => options.HangPolicy = Soon.AndCall(_ =>
        {
            found.Set();
            throw new InvalidOperationException("my own fault");
        }));
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        for (int i = 0; i < 2; i++)
            run.OnAndSettle(manager, () => Assert.True(found.WaitOne(TestTimeout.Limit)));
        run.Finish();

        Assert.All(
            run.Log.Where(e => e.Kind == RabitLogKind.Fault),
            e => Assert.StartsWith(
                "the callback of its hang policy threw InvalidOperationException: my own fault", e.Text,
                StringComparison.Ordinal));
        Assert.Equal(2, run.Log.Count(e => e.Kind == RabitLogKind.Fault));
    }

    [Theory, Trait("Clause", "4.5")]
    [InlineData(null, "m hangs in UnitOfWork for 1.500 s")]
    [InlineData("reading", "m hangs in UnitOfWork for 1.500 s: reading")]
    public void Hang_AsText_SaysWhereHowLongAndWhatItDid(string? doing, string text)
        => Assert.Equal(
            text,
            new ManagerHang(
                "m", ManagerStage.UnitOfWork, doing, TimeSpan.Zero, TimeSpan.FromMilliseconds(1500)).ToString());

    [Fact, Trait("Clause", "4.5")]
    public void Off_ManagerThatTakesLong_IsNotFound()
    {
        using var found = new ManualResetEventSlim();
        var clock = new ManualClock();
        using TestRun run = NewRun(clock, Soon.AndCall(_ => found.Set()));
        ScriptedManager watched = run.Add("watched");
        ScriptedManager manager = run.Add("m");
        manager.HangPolicy = HangPolicy.Off;
        manager.OnUnit = () =>
        {
            // Until the other one, which hangs no longer than this one does, is found.
            watched.OnUnit = () =>
            {
                if (found.IsSet)
                    return;
                clock.Timestamp += PastTheLimit.Ticks;
                Assert.True(found.Wait(TestTimeout.Limit));
            };
            watched.WakeUp();
            Assert.True(found.Wait(TestTimeout.Limit));
        };

        run.StartAndSettle();
        ReactorResult result = run.Finish();

        Assert.Equal((1, 0), (result.Managers[0].HangCount, result.Managers[1].HangCount));
    }

    [Fact, Trait("Clause", "1.6")]
    public void TotalStopTimeout_IsOver_TheRestIsAskedAtOnceAndEndsAllTheSame()
    {
        using var release = new ManualResetEventSlim();
        using var run = new TestRun(TimeKind.Real, options =>
        {
            options.TotalStopTimeout = TimeSpan.FromMilliseconds(50);
            options.StopTimeout = TestTimeout.Limit;
        });
        ScriptedManager first = run.Add("first");
        ScriptedManager second = run.Add("second");
        ScriptedManager hanging = run.Add("m");
        int together = 0;

        // Both of the rest are in their shutdowns at one time: in order, the first would wait for the second.
        first.OnShutdown = second.OnShutdown = () =>
        {
            Interlocked.Increment(ref together);
            SpinWait.SpinUntil(() => Volatile.Read(ref together) == 2, TimeSpan.FromMilliseconds(500));
        };
        hanging.OnUnit = () =>
        {
            run.Board.Write("hangs");
            release.Wait();
        };

        run.Start();
        run.Until(() => run.Board.Count("hangs") == 1, "it hangs");
        ReactorResult result = run.Finish();
        release.Set();

        Assert.Equal(ManagerOutcome.DidNotStop, result.Managers[2].Outcome);
        run.Until(() => Volatile.Read(ref together) == 2, "the rest has shut down");
        Assert.Contains(run.Log, e => e.Text.Contains("asked to stop at once", StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "4.5")]
    public void Limits_Bad_AreRefused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => HangPolicy.Report.WithLimits(TimeSpan.Zero));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => HangPolicy.Report.WithLimits(TimeSpan.FromSeconds(1), startup: TimeSpan.FromSeconds(-2)));
        Assert.Equal(
            Timeout.InfiniteTimeSpan,
            HangPolicy.Report.WithLimits(TimeSpan.FromSeconds(1), shutdown: Timeout.InfiniteTimeSpan).ShutdownLimit);
    }

    private static TestRun NewRun(ManualClock clock, HangPolicy policy) => new(TimeKind.Real, options =>
    {
        options.Time = new RealTime(clock);
        options.HangPolicy = policy;
    });

    private static void Hang(ScriptedManager manager, ManagerStage stage, Action hang, int unit = 1)
    {
        switch (stage)
        {
            case ManagerStage.Startup:
                manager.OnStartup = hang;
                break;
            case ManagerStage.UnitOfWork:
                manager.OnUnit = () =>
                {
                    if (manager.Units == unit)
                        hang();
                };
                break;
            default:
                manager.OnShutdown = hang;
                break;
        }
    }
}
