using System;
using System.Linq;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 4.4: what a manager reports of itself (counts and simple times).</summary>
public abstract class StatusContract(TimeKind kind) : ContractTests(kind)
{
    [Fact, Trait("Clause", "4.4")]
    public void State_ThroughALife_IsCreatedRunningStopped()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.OnStartup = () => run.Board.Write("startup " + Seen(run));

        run.StartAndSettle();
        Assert.Equal(ManagerState.Running, run.StatusOf(manager).State);
        run.Finish();

        Assert.Equal(ManagerState.Stopped, run.StatusOf(manager).State);

        string Seen(TestRun r) => r.Reactor.Workspace.SubscribeToStatus("m").Value.State.ToString();
        Assert.Equal(["startup Created"], run.Board.Entries);
    }

    [Fact, Trait("Clause", "4.4")]
    public void State_WhileAnotherStartsUp_IsStarting()
    {
        using TestRun run = NewRun();
        ScriptedManager first = run.Add("first");
        ScriptedManager second = run.Add("second");
        second.OnStartup = () => run.Board.Write(LateStatus(run, "first").State.ToString());

        run.StartAndSettle();

        Assert.Equal(["Starting"], run.Board.Entries);
        Assert.Equal(1, first.Startups);
    }

    [Fact, Trait("Clause", "4.4")]
    public void Counts_EachCause_AreKept()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        ScriptedManager other = run.Add("other");
        QueueSender<int> fromOther = other.Send<int>("in");
        QueueReceiver<int> inbox = manager.Receive<int>("in");
        QueueSender<int> toOther = manager.Send<int>("out", wakeOnPop: true);
        QueueReceiver<int> othersInbox = other.Receive<int>("out", wakeOnPush: false);
        MessagePublisher<int> publisher = other.Publish<int>("height");
        manager.Subscribe<int>("height", wakeOnPost: true);

        run.StartAndSettle();
        run.OnAndSettle(other, () => fromOther.Push(1));
        Settle(run, manager, 2);
        run.OnAndSettle(other, publisher.Post);
        Settle(run, manager, 3);
        run.OnAndSettle(manager, () =>
        {
            inbox.TryPop(out _);
            toOther.Push(1);
        });
        run.OnAndSettle(other, () => othersInbox.TryPop(out _));
        Settle(run, manager, 5);
        run.OnAndSettle(manager, () => manager.WakeUpDelay = TimeSpan.FromMilliseconds(5));
        run.Until(() => run.StatusOf(manager).WakeUps.Timer > 0, "the timer wakes it");
        run.Finish();

        ManagerStatus status = run.StatusOf(manager);
        Assert.Equal((1, 1, 1, 2, 0), (status.WakeUps.Push, status.WakeUps.Post, status.WakeUps.Pop,
            status.WakeUps.Request, status.WakeUps.Device));
        Assert.Equal(manager.Units, status.Runs);
        Assert.Equal(status.Runs, status.UnitOfWorkTime.Count);
    }

    [Fact, Trait("Clause", "4.4")]
    public void WakeLatency_EveryWakeFromSleep_IsMeasured()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        // With threads a wake may come before the manager has fallen asleep, and is none from sleep then.
        run.StartAndSettle();
        for (int i = 0; i < 1000 && run.StatusOf(manager).WakeLatency.Count < 2; i++)
            run.OnAndSettle(manager, () => { });
        ManagerStatus status = run.StatusOf(manager);

        Assert.Equal(2, status.WakeLatency.Count);
        Assert.Equal(status.WakeLatency.Total.Ticks / 2, status.WakeLatency.Mean.Ticks);
        Assert.InRange(status.WakeLatency.Max, TimeSpan.Zero, run.Reactor.Now);
        Assert.InRange(status.LastRunAt, TimeSpan.Zero, run.Reactor.Now);
        if (!Kind.HasThreads)
            Assert.Equal(TimeSpan.Zero, status.WakeLatency.Max);
    }

    [Fact, Trait("Clause", "4.4")]
    public void WakeLatency_WakeDuringAUnit_IsNone()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        manager.OnUnit = () =>
        {
            if (manager.Units < 10)
                manager.WakeUp();
        };
        manager.WakeUp();
        Settle(run, manager, 10);

        // The start and the first wake, where they found it asleep; not the eight that it gave itself.
        Assert.InRange(run.StatusOf(manager).WakeLatency.Count, Kind.HasThreads ? 0 : 2, 2);
    }

    [Fact, Trait("Clause", "4.4")]
    public void Subscription_ByAManager_WakesItAtEachStatus()
    {
        using TestRun run = NewRun();
        ScriptedManager watched = run.Add("watched");
        ScriptedManager watcher = run.Add("watcher");
        MessageSubscriber<ManagerStatus> status = watcher.SubscribeToStatus("watched", wakeOnPost: true);
        long seen = 0;
        watcher.OnUnit = () =>
        {
            if (status.Fetch())
                seen = status.Value.Runs;
            run.Board.Changed();
        };

        run.StartAndSettle();
        for (int i = 0; i < 3; i++)
            run.OnAndSettle(watched, () => { });
        run.Until(() => seen == 4, "the watcher sees the last status");

        Assert.Contains(watcher.Causes, cause => (cause & WakeUpCauses.Post) != 0);
    }

    [Fact, Trait("Clause", "4.4")]
    public void ResetStatistics_Later_ResetsTheFiguresAndKeepsFaults()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.FaultPolicy = FaultPolicy.CarryOnAfter(TimeSpan.FromMilliseconds(1), TimeSpan.FromMilliseconds(1));
        manager.OnUnit = () =>
        {
            if (manager.Units == 1)
                throw new InvalidOperationException("once");
        };

        run.StartAndSettle();
        run.OnAndSettle(manager, () => { });
        run.OnAndSettle(manager, () => { });
        manager.ResetStatistics();
        run.On(manager, () => { });
        run.Until(() => run.StatusOf(manager).Runs == 1, "the figures start again");
        ManagerStatus status = run.StatusOf(manager);
        ReactorResult result = run.Finish();

        Assert.Equal(1, status.UnitOfWorkTime.Count);
        Assert.Equal(1, status.WakeUps.Request);
        Assert.Equal(1, status.Faults);
        Assert.Contains("once", status.LastFault, StringComparison.Ordinal);
        Assert.Equal(manager.Units, result.Managers[0].Runs);
    }

    [Fact, Trait("Clause", "4.4")]
    public void Percentiles_OfAllFigures_AreInTheLastStatus()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.Period = TimeSpan.FromMilliseconds(2);

        run.Start();
        run.Until(() => manager.Units >= 20, "it runs for a while");
        ReactorResult result = run.Finish();

        ManagerStatus status = result.Managers[0].Status;
        Assert.Equal(run.StatusOf(manager).Runs, status.Runs);
        Assert.Equal(manager.Units - 1, status.PeriodError.Count);
        foreach (DurationStatistics figure in new[] { status.UnitOfWorkTime, status.WakeLatency, status.PeriodError })
        {
            Assert.InRange(figure.Percentile50, figure.Min, figure.Percentile99);
            Assert.InRange(figure.Percentile99, figure.Percentile50, figure.Percentile999);
            Assert.InRange(figure.Percentile999, figure.Percentile99, figure.Max);
        }

        if (Kind.HasThreads)
            Assert.NotEqual(TimeSpan.Zero, status.UnitOfWorkTime.Percentile50);
        else
            Assert.Equal((TimeSpan.Zero, TimeSpan.Zero), (status.UnitOfWorkTime.Max, status.PeriodError.Max));
    }

    [Fact, Trait("Clause", "4.4")]
    public void KeepsStatistics_Off_CountsRunsAndMeasuresNothing()
    {
        using TestRun run = NewRun(options => options.KeepsStatistics = false);
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        run.OnAndSettle(manager, () => { });
        ManagerStatus status = run.Finish().Managers[0].Status;

        Assert.Equal((2, 1), (status.Runs, status.WakeUps.Request));
        Assert.Equal((0, 0), (status.UnitOfWorkTime.Count, status.WakeLatency.Count));
    }

    [Fact, Trait("Clause", "4.4")]
    public void Table_OfALiveRunAndOfAResult_HasALineForEachManager()
    {
        using TestRun run = NewRun();
        Assert.Empty(run.Reactor.StatusTable());
        ScriptedManager manager = run.Add("m");
        run.Add("the other one");

        run.StartAndSettle();
        run.OnAndSettle(manager, () => { });
        string live = run.Reactor.StatusTable();
        string last = run.Finish().ToTable();

        foreach (string table in new[] { live, last })
        {
            string[] lines = table.Split('\n');
            Assert.StartsWith("manager ", lines[0], StringComparison.Ordinal);
            Assert.StartsWith("m ", lines[1], StringComparison.Ordinal);
            Assert.StartsWith("the other one ", lines[2], StringComparison.Ordinal);
            Assert.Equal(
                lines[1].IndexOf(" 2 ", StringComparison.Ordinal), lines[2].IndexOf(" 1 ", StringComparison.Ordinal));
        }

        Assert.Contains("Ended", last, StringComparison.Ordinal);
        Assert.Contains("sleeping", live, StringComparison.Ordinal);
        Assert.DoesNotContain("sleeping", run.Reactor.StatusTable(), StringComparison.Ordinal);
    }

    [Fact]
    public void StatusTable_OfAManagerThatHasNotBegun_SaysThatItWasCreated()
    {
        using TestRun run = NewRun();
        string early = string.Empty;
        run.Add("first").OnStartup = () =>
        {
            early = run.Reactor.StatusTable();
            run.Reactor.Stop("early");
        };
        run.Add("second");
        run.Start();
        run.FinishByItself();

        if (!Kind.HasThreads)   // with threads the second one may have begun meanwhile
            Assert.Contains("created", early.Split('\n')[2], StringComparison.Ordinal);

        using TestRun none = NewRun();
        none.Add("m");
        none.Reactor.Stop("never mind");
        none.Start();
        none.FinishByItself();
        string late = none.Reactor.StatusTable();

        Assert.Contains("created", late, StringComparison.Ordinal);
        Assert.DoesNotContain("sleeping", late, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "4.4"), Trait("Clause", "4.2")]
    public void Subscription_ToNoSuchManager_IsAWiringFault()
    {
        using TestRun run = NewRun();
        run.Add("m").SubscribeToStatus("ghost");

        Assert.Contains(
            "'ghost/status'", Assert.Single(Assert.Throws<RabitWiringException>(run.Start).Faults),
            StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "4.4")]
    public void Stamp_OfEveryStatus_IsTheTimeOfTheChange()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        TimeSpan atShutdown = default;
        manager.OnShutdown = () => atShutdown = manager.Time;
        MessageSubscriber<ManagerStatus> status = run.Reactor.Workspace.SubscribeToStatus("m");

        run.StartAndSettle();
        run.Reactor.RunFor(TimeSpan.FromMilliseconds(20));
        run.Finish();
        status.Fetch();

        Assert.InRange(status.Stamp.Time, atShutdown, run.Reactor.Now);
    }

    private static void Settle(TestRun run, ScriptedManager manager, long runs)
        => run.Until(() => run.StatusOf(manager).Runs == runs, $"{manager.Name} ends run {runs}");

    private static ManagerStatus LateStatus(TestRun run, string name)
    {
        MessageSubscriber<ManagerStatus> status = run.Reactor.Workspace.SubscribeToStatus(name);
        status.Fetch();
        return status.Value;
    }
}

public sealed class StatusInRealTime() : StatusContract(TimeKind.Real);

public sealed class StatusInVirtualTime() : StatusContract(TimeKind.Virtual);
