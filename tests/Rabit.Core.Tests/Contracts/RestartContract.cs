using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 1.1 and 1.7: a manager that is restarted.</summary>
public abstract class RestartContract(TimeKind kind) : ContractTests(kind)
{
    private static readonly TimeSpan Minute = TimeSpan.FromMinutes(1);

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "1.1")]
    public void Restart_UnitThrows_ShutsDownStartsUpAndRunsAgainWithCauseStart()
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = AddRestarting(run, milliseconds: 5, most: 3);
        faulty.OnStartup = () => run.Board.Write("startup");
        faulty.OnShutdown = () => run.Board.Write("shutdown");
        faulty.OnUnit = () =>
        {
            run.Board.Write("unit");
            if (faulty.Units == 1)
                throw new InvalidOperationException("once");
        };

        run.Start();
        run.Until(() => run.StatusOf(faulty).Runs == 2, "it runs again");
        Assert.Equal(ManagerState.Running, run.StatusOf(faulty).State);
        ReactorResult result = run.Finish();

        Assert.Equal(["startup", "unit", "shutdown", "startup", "unit", "shutdown"], run.Board.Entries);
        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Start], faulty.Causes);
        Assert.Equal((1, 1), (result.Managers[0].Restarts, run.StatusOf(faulty).Restarts));
        Assert.Equal(ManagerOutcome.Faulted, result.Managers[0].Outcome);
        Assert.Equal(1, result.ExitCode);
        Assert.Contains(
            run.Log, e => e.Kind == RabitLogKind.Lifecycle && e.Text.Contains("restart 1", StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "1.7")]
    public void Restart_WhileItWaits_IsReported()
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = AddRestarting(run, milliseconds: 3_600_000, most: 3);
        faulty.OnUnit = () => throw new InvalidOperationException("boom");

        run.Start();
        run.Until(() => run.StatusOf(faulty).State == ManagerState.Restarting, "it waits for its restart");
        ReactorResult result = run.Finish();

        // The stop ends the wait at once, and the shutdown of the start-up before is not repeated.
        Assert.Equal((1, 1), (faulty.Startups, faulty.Shutdowns));
        Assert.Equal(0, result.Managers[0].Restarts);
        Assert.Equal(ManagerState.Stopped, run.StatusOf(faulty).State);
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "1.1")]
    public void Restart_QueuesAndMessageVersions_AreKept()
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = AddRestarting(run, milliseconds: 30, most: 3);
        ScriptedManager other = run.Add("other");
        using ManualResetEventSlim mayStartAgain = HoldTheSecondStartup(faulty);
        QueueReceiver<int> inbox = faulty.Receive<int>("inbox", wakeOnPush: false);
        QueueSender<int> outbox = other.Send<int>("inbox");
        MessagePublisher<int> published = faulty.Publish<int>("height");
        MessageSubscriber<int> seen = other.Subscribe<int>("height");
        var got = new List<int>();
        faulty.OnUnit = () =>
        {
            published.Value = faulty.Units;
            published.Post();
            if (faulty.Units == 1)
                throw new InvalidOperationException("once");
            while (inbox.TryPop(out int value))
                got.Add(value);
        };

        run.Start();
        run.Until(() => run.StatusOf(faulty).State == ManagerState.Restarting, "it waits for its restart");
        run.OnAndSettle(other, () =>
        {
            Assert.Equal(PushResult.Queued, outbox.Push(7));
            Assert.True(seen.Fetch());
            Assert.Equal((1, 1), (seen.Value, seen.Stamp.Version));
        });
        mayStartAgain.Set();
        run.Until(() => run.StatusOf(faulty).Runs == 2, "it runs again");
        run.OnAndSettle(other, () =>
        {
            Assert.True(seen.Fetch());
            Assert.Equal((2, 2), (seen.Value, seen.Stamp.Version));
        });

        Assert.Equal([7], got);
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "1.4")]
    public void Restart_WakesDuringTheDelay_AreKeptForTheFirstRun()
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = AddRestarting(run, milliseconds: 30, most: 3);
        ScriptedManager waker = run.Add("waker");
        using ManualResetEventSlim mayStartAgain = HoldTheSecondStartup(faulty);
        faulty.OnUnit = () =>
        {
            if (faulty.Units == 1)
                throw new InvalidOperationException("once");
        };

        run.Start();
        run.Until(() => run.StatusOf(faulty).State == ManagerState.Restarting, "it waits for its restart");
        run.On(waker, faulty.WakeUp);
        mayStartAgain.Set();
        run.Until(() => run.StatusOf(faulty).Runs == 2, "it runs again");

        Assert.Equal(WakeUpCauses.Start | WakeUpCauses.Request, faulty.Causes[1]);
    }

    [Theory, Trait("Clause", "1.7")]
    [InlineData(ManagerStage.Startup, FaultAction.StopSystem)]
    [InlineData(ManagerStage.Startup, FaultAction.StopManager)]
    [InlineData(ManagerStage.UnitOfWork, FaultAction.StopSystem)]
    [InlineData(ManagerStage.UnitOfWork, FaultAction.StopManager)]
    public void Restart_ThrowsEachTime_BacksOffByDoublingAndEndsAsThePolicySays(ManagerStage stage, FaultAction end)
    {
        var times = new List<TimeSpan>();
        using TestRun run = NewRun();
        ScriptedManager faulty = AddRestarting(run, milliseconds: 2, most: 4, end);
        ScriptedManager other = run.Add("other");
        faulty.ThrowIn(stage, () => times.Add(faulty.Time));

        run.Start();
        ReactorResult result;
        if (end == FaultAction.StopSystem)
        {
            result = run.FinishByItself();
            Assert.Contains("4 restarts within 00:01:00", result.StopReason, StringComparison.Ordinal);
        }
        else
        {
            run.Until(
                () => faulty.Shutdowns == 5 && run.StatusOf(faulty).State == ManagerState.Faulted, "it is stopped");
            run.OnAndSettle(other, () => { });
            result = run.Finish();
        }

        // 2, 4, 8, and 10 ms, the longest.
        Assert.Equal(5, times.Count);
        double[] expected = [2, 4, 8, 10];
        for (int i = 0; i < expected.Length; i++)
        {
            double gap = (times[i + 1] - times[i]).TotalMilliseconds;
            Assert.True(Kind.HasThreads ? gap >= expected[i] : gap == expected[i], $"restart {i}: {gap} ms");
        }

        Assert.Contains(
            run.Log,
            e => e.Text.StartsWith("is not restarted any more: ", StringComparison.Ordinal)
                && e.Text.EndsWith("boom, after 4 restarts within 00:01:00", StringComparison.Ordinal));
        Assert.Equal((5, 5), (faulty.Startups, faulty.Shutdowns));
        Assert.Equal((4, 5), (result.Managers[0].Restarts, result.Managers[0].FaultCount));
        Assert.Equal(
            end == FaultAction.StopSystem ? ManagerOutcome.Faulted : ManagerOutcome.StoppedAlone,
            result.Managers[0].Outcome);
        Assert.Equal(ManagerOutcome.Ended, result.Managers[1].Outcome);
        Assert.Equal(1, result.ExitCode);
    }

    [Fact, Trait("Clause", "1.7")]
    public void Restart_FaultsFurtherApartThanTheWindow_GoesOnForEver()
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = run.Add("faulty");
        var window = TimeSpan.FromMilliseconds(4);
        faulty.FaultPolicy = FaultPolicy.RestartAfter(window, window, maxRestarts: 1, window);
        faulty.OnUnit = () => throw new InvalidOperationException("boom");

        run.Start();
        run.Until(() => faulty.Units >= 10, "it is restarted again and again");
        Assert.True(run.Finish().Managers[0].Restarts >= 9);
    }

    [Fact, Trait("Clause", "1.7")]
    public void Restart_ShutdownThrowsToo_IsReportedAndRestartsAllTheSame()
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = AddRestarting(run, milliseconds: 2, most: 3);
        faulty.OnUnit = () =>
        {
            if (faulty.Units == 1)
                throw new InvalidOperationException("work");
        };
        faulty.OnShutdown = () =>
        {
            if (faulty.Shutdowns == 1)
                throw new InvalidOperationException("end");
        };

        run.Start();
        run.Until(() => run.StatusOf(faulty).Runs == 2, "it runs again");
        ManagerResult result = run.Finish().Managers[0];

        Assert.Equal(["work", "end"], result.Faults.Select(f => f.Exception.Message));
        Assert.Equal(1, result.Restarts);
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "4.3")]
    public void Restart_StartupThrows_DoesNotHoldTheBarrierForTheOthers()
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = AddRestarting(run, milliseconds: 3_600_000, most: 3);
        ScriptedManager other = run.Add("other");
        faulty.ThrowIn(ManagerStage.Startup);

        run.Start();
        run.Until(() => run.StatusOf(other).Runs == 1, "the other one works");
        run.Finish();

        Assert.Equal(0, faulty.Units);
        Assert.Equal((1, 1), (faulty.Startups, faulty.Shutdowns));
    }

    [Fact, Trait("Clause", "1.7"), Trait("Clause", "1.6")]
    public void Restart_StopDuringItsStartup_RunsNoUnit()
    {
        using TestRun run = NewRun();
        ScriptedManager faulty = AddRestarting(run, milliseconds: 2, most: 3);
        faulty.OnUnit = () => throw new InvalidOperationException("boom");
        faulty.OnStartup = () =>
        {
            // In real time the stop reaches the manager's thread before its start-up returns.
            if (faulty.Startups != 2)
                return;
            faulty.StopAll("seen enough");
            run.Board.Write("stopped");
            if (Kind.HasThreads)
                Assert.True(
                    System.Threading.SpinWait.SpinUntil(
                        () => faulty.WakeUpEvent.StopRequested, TestTimeout.Limit));
        };

        run.Start();
        run.FinishByItself();

        Assert.Equal((2, 1, 2), (faulty.Startups, faulty.Units, faulty.Shutdowns));
    }

    [Fact, Trait("Clause", "1.7")]
    public void RestartAfter_BadFigures_AreRefused()
    {
        TimeSpan one = TimeSpan.FromSeconds(1);
        Assert.Throws<ArgumentOutOfRangeException>(() => FaultPolicy.RestartAfter(TimeSpan.Zero, one, 1, Minute));
        Assert.Throws<ArgumentOutOfRangeException>(() => FaultPolicy.RestartAfter(one + one, one, 1, Minute));
        Assert.Throws<ArgumentOutOfRangeException>(() => FaultPolicy.RestartAfter(one, one, 0, Minute));
        Assert.Throws<ArgumentOutOfRangeException>(() => FaultPolicy.RestartAfter(one, one, 1001, Minute));
        Assert.Throws<ArgumentOutOfRangeException>(() => FaultPolicy.RestartAfter(one, one, 1, TimeSpan.Zero));
        Assert.Throws<ArgumentOutOfRangeException>(
            () => FaultPolicy.RestartAfter(one, one, 1, Minute, FaultAction.CarryOn));
    }

    // However slow the machine is: what a test does between fault and restart comes before the second start-up has
    // ended. In virtual time it comes before that begins, so nothing waits.
    private static ManualResetEventSlim HoldTheSecondStartup(ScriptedManager manager)
    {
        var mayStartAgain = new ManualResetEventSlim();
        manager.OnStartup = () =>
        {
            if (manager.Startups == 2)
                Assert.True(mayStartAgain.Wait(TestTimeout.Limit));
        };
        return mayStartAgain;
    }

    private static ScriptedManager AddRestarting(
        TestRun run, int milliseconds, int most, FaultAction end = FaultAction.StopSystem)
    {
        ScriptedManager manager = run.Add("faulty");
        var first = TimeSpan.FromMilliseconds(milliseconds);
        manager.FaultPolicy = FaultPolicy.RestartAfter(first, new TimeSpan(first.Ticks * 5), most, Minute, end);
        return manager;
    }
}

public sealed class RestartInRealTime() : RestartContract(TimeKind.Real);

public sealed class RestartInVirtualTime() : RestartContract(TimeKind.Virtual);
