using System;
using System.Collections.Generic;
using System.Linq;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 1.1 to 1.6: the life of a manager, its sleep and what wakes it.</summary>
public abstract class ManagerContract(TimeKind kind) : ContractTests(kind)
{
    [Fact, Trait("Clause", "1.1")]
    public void Life_OneRun_StartupUnitsShutdownOnceEachInOrder()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.OnStartup = () => run.Board.Write("startup");
        manager.OnUnit = () => run.Board.Write("unit");
        manager.OnShutdown = () => run.Board.Write("shutdown");

        run.StartAndSettle();
        run.OnAndSettle(manager, () => { });
        run.Finish();

        Assert.Equal(["startup", "unit", "unit", "shutdown"], run.Board.Entries);
    }

    [Fact, Trait("Clause", "1.1")]
    public void FirstUnit_AfterTheBarrier_RunsAtOnceWithCauseStart()
    {
        using TestRun run = NewRun();
        ScriptedManager first = run.Add("first");
        ScriptedManager second = run.Add("second");

        run.StartAndSettle();
        run.Finish();

        Assert.Equal([WakeUpCauses.Start], first.Causes);
        Assert.Equal([WakeUpCauses.Start], second.Causes);
    }

    [Fact, Trait("Clause", "1.1")]
    public void WakeBeforeTheBarrier_IsKept_AndComesWithTheFirstUnit()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.OnStartup = manager.WakeUp;

        run.StartAndSettle();
        run.Finish();

        Assert.Equal([WakeUpCauses.Start | WakeUpCauses.Request], manager.Causes);
    }

    [Fact, Trait("Clause", "1.1"), Trait("Clause", "1.6")]
    public void Stop_WhileAsleep_CausesNoExtraRun()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        ReactorResult result = run.Finish();

        Assert.Equal(1, manager.Units);
        Assert.Equal(1, manager.Shutdowns);
        Assert.Equal(1, result.Managers[0].Runs);
    }

    [Fact, Trait("Clause", "1.2")]
    public void Sleep_NothingToWakeIt_RunsNoUnit()
    {
        using TestRun run = NewRun();
        ScriptedManager sleeper = run.Add("sleeper");
        ScriptedManager busy = run.Add("busy");
        MessagePublisher<int> publisher = busy.Publish<int>("count");
        MessageSubscriber<int> subscriber = sleeper.Subscribe<int>("count");
        QueueSender<int> sender = sleeper.Send<int>("queue");
        QueueReceiver<int> receiver = busy.Receive<int>("queue", wakeOnPush: false);
        QueueReceiver<int> quiet = sleeper.Receive<int>("quiet", wakeOnPush: false);
        QueueSender<int> toQuiet = busy.Send<int>("quiet");

        run.StartAndSettle();
        run.OnAndSettle(sleeper, () => sender.Push(1));
        for (int i = 0; i < 50; i++)
        {
            run.OnAndSettle(busy, () =>
            {
                publisher.Post();
                toQuiet.Push(1);
                receiver.TryPop(out _);
            });
        }

        // Whatever had woken it in vain would come together with this request.
        run.OnAndSettle(sleeper, () => Assert.True(subscriber.Fetch()));
        run.Finish();

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Request, WakeUpCauses.Request], sleeper.Causes);
        Assert.Equal("quiet", quiet.Name);
    }

    [Fact, Trait("Clause", "1.2"), Trait("Clause", "1.5")]
    public void Wake_ByPost_RunsWithCausePost()
    {
        using TestRun run = NewRun();
        ScriptedManager poster = run.Add("poster");
        ScriptedManager sleeper = run.Add("sleeper");
        MessagePublisher<int> publisher = poster.Publish<int>("count");
        sleeper.Subscribe<int>("count", wakeOnPost: true);

        run.StartAndSettle();
        run.On(poster, publisher.Post);
        run.Until(() => sleeper.Units == 2, "the post wakes the sleeper");

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Post], sleeper.Causes);
    }

    [Fact, Trait("Clause", "1.2"), Trait("Clause", "1.5"), Trait("Clause", "3.2")]
    public void Wake_ByPush_RunsWithCausePush()
    {
        using TestRun run = NewRun();
        ScriptedManager pusher = run.Add("pusher");
        ScriptedManager sleeper = run.Add("sleeper");
        QueueSender<int> sender = pusher.Send<int>("queue");
        sleeper.Receive<int>("queue");

        run.StartAndSettle();
        run.On(pusher, () => sender.Push(1));
        run.Until(() => sleeper.Units == 2, "the push wakes the sleeper");

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Push], sleeper.Causes);
    }

    [Fact, Trait("Clause", "1.2"), Trait("Clause", "1.5"), Trait("Clause", "3.2")]
    public void Wake_ByPop_RunsWithCausePop()
    {
        using TestRun run = NewRun();
        ScriptedManager sleeper = run.Add("sleeper");
        ScriptedManager popper = run.Add("popper");
        QueueSender<int> sender = sleeper.Send<int>("queue", wakeOnPop: true);
        QueueReceiver<int> receiver = popper.Receive<int>("queue", wakeOnPush: false);

        run.StartAndSettle();
        run.OnAndSettle(sleeper, () => sender.Push(1));
        run.On(popper, () => Assert.True(receiver.TryPop(out _)));
        run.Until(() => sleeper.Units == 3, "the pop wakes the sleeper");

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Request, WakeUpCauses.Pop], sleeper.Causes);
    }

    [Fact, Trait("Clause", "1.2"), Trait("Clause", "1.5")]
    public void Wake_ByTimer_RunsWithCauseTimer()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.FromMilliseconds(5);

        run.Start();
        run.Until(() => manager.Units >= 4, "the timer wakes it three times");
        run.Finish();

        Assert.Equal(WakeUpCauses.Start, manager.Causes[0]);
        Assert.All(manager.Causes.Skip(1), cause => Assert.Equal(WakeUpCauses.Timer, cause));
    }

    [Fact, Trait("Clause", "1.2"), Trait("Clause", "1.5")]
    public void Wake_FromOutside_RunsWithCauseRequest()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        manager.WakeUp();
        run.Until(() => manager.Units == 2, "the request wakes it");

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Request], manager.Causes);
    }

    [Fact, Trait("Clause", "1.3")]
    public void WakeUpDelay_NotSet_IsOneSecond()
        => Assert.Equal(TimeSpan.FromSeconds(1), new PlainManager().WakeUpDelay);

    [Theory, Trait("Clause", "1.3")]
    [InlineData(0)]
    [InlineData(-1)]
    public void WakeUpDelay_NotPositive_IsRefusedByName(long ticks)
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("lazy");

        var error = Assert.Throws<ArgumentOutOfRangeException>(() => manager.WakeUpDelay = TimeSpan.FromTicks(ticks));

        Assert.Contains("'lazy'", error.Message, StringComparison.Ordinal);
        Assert.Equal(TimeSpan.FromHours(1), manager.WakeUpDelay);
    }

    [Fact, Trait("Clause", "1.3")]
    public void WakeUpDelay_Longest_IsLegalAndWakesStillCome()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.MaxValue;

        run.StartAndSettle();
        run.OnAndSettle(manager, () => { });
        run.Finish();

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Request], manager.Causes);
    }

    [Fact, Trait("Clause", "1.3")]
    public void Timer_BetweenUnits_StartsWhenTheManagerGoesToSleepAndIsNeverEarly()
    {
        var delay = TimeSpan.FromMilliseconds(20);
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = delay;
        var begins = new List<TimeSpan>();
        var ends = new List<TimeSpan>();
        manager.OnUnit = () =>
        {
            begins.Add(manager.Time);
            ends.Add(manager.Time);
        };

        run.Start();
        run.Until(() => manager.Units >= 5, "five units run");
        run.Finish();

        for (int i = 1; i < begins.Count; i++)
            Assert.True(begins[i] - ends[i - 1] >= delay, $"unit {i} came after {begins[i] - ends[i - 1]}");
    }

    [Fact, Trait("Clause", "1.3")]
    public void WakeUpDelay_ChangedInAUnit_HoldsFromTheNextSleep()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        run.On(manager, () => manager.WakeUpDelay = TimeSpan.FromMilliseconds(5));
        run.Until(() => manager.Units >= 4, "the short timer wakes it");
        run.On(manager, () => manager.WakeUpDelay = TimeSpan.FromHours(1));
        int units = manager.Units;
        run.OnAndSettle(manager, () => { });
        run.Finish();

        Assert.Equal(WakeUpCauses.Timer, manager.Causes[2]);
        Assert.Equal(TimeSpan.FromHours(1), run.StatusOf(manager).WakeUpDelay);
        Assert.DoesNotContain(manager.Causes.Skip(units), cause => (cause & WakeUpCauses.Timer) != 0);
    }

    [Fact, Trait("Clause", "1.4")]
    public void Wakes_DuringAUnit_CauseExactlyOneMore()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        run.On(manager, () =>
        {
            for (int i = 0; i < 5; i++)
                manager.WakeUp();
        });
        run.Until(() => run.StatusOf(manager).Runs == 3, "the wakes cause one more run");
        run.OnAndSettle(manager, () => { });
        run.Finish();

        ManagerStatus status = run.StatusOf(manager);
        Assert.Equal(4, manager.Units);
        Assert.Equal(3, status.WakeUps.Request);
        Assert.Equal(4, status.WakeUps.Merged);
    }

    [Fact, Trait("Clause", "1.4")]
    public void Wakes_WhileAsleep_DoNotStackAndAreAllAccountedFor()
    {
        const int Wakes = 1000;
        using TestRun run = NewRun();
        ScriptedManager sleeper = run.Add("sleeper");
        ScriptedManager waker = run.Add("waker");

        run.StartAndSettle();
        run.On(waker, () =>
        {
            for (int i = 0; i < Wakes; i++)
                sleeper.WakeUp();
        });
        run.Until(
            () => run.StatusOf(sleeper).WakeUps is var w && w.Request + w.Merged == Wakes, "every wake causes a run or merges with another");

        // Without threads nothing runs between the wakes: they are one.
        if (!Kind.HasThreads)
            Assert.Equal(2, sleeper.Units);
    }

    [Fact, Trait("Clause", "1.4")]
    public void OwnPost_WakeOnPost_NeitherWakesNorIsNews()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        MessagePublisher<int> publisher = manager.Publish<int>("count");
        MessageSubscriber<int> subscriber = manager.Subscribe<int>("count", wakeOnPost: true);

        run.StartAndSettle();
        run.OnAndSettle(manager, publisher.Post);
        run.OnAndSettle(manager, () => Assert.False(subscriber.Fetch()));
        run.Finish();

        Assert.Equal([WakeUpCauses.Start, WakeUpCauses.Request, WakeUpCauses.Request], manager.Causes);
    }

    [Fact, Trait("Clause", "1.4")]
    public void OwnPush_QueueThatOneReceives_Wakes()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        QueueSender<int> sender = manager.Send<int>("queue");
        manager.Receive<int>("queue");

        run.StartAndSettle();
        run.On(manager, () => sender.Push(1));
        run.Until(() => manager.Units == 3, "its own push wakes it");

        Assert.Equal(WakeUpCauses.Push, manager.Causes[2]);
    }

    [Fact, Trait("Clause", "1.4")]
    public void PostAndPush_ThatReturned_AreSeenByALaterUnit()
    {
        const int Rounds = 500;
        using TestRun run = NewRun();
        ScriptedManager source = run.Add("source");
        ScriptedManager sink = run.Add("sink");
        MessagePublisher<int> publisher = source.Publish<int>("count");
        MessageSubscriber<int> subscriber = sink.Subscribe<int>("count", wakeOnPost: true);
        QueueSender<int> sender = source.Send<int>("queue");
        QueueReceiver<int> receiver = sink.Receive<int>("queue", capacity: Rounds);
        int lastPost = 0;
        int lastPop = 0;
        sink.OnUnit = () =>
        {
            if (subscriber.Fetch())
                lastPost = subscriber.Value;
            while (receiver.TryPop(out int value))
                lastPop = value;
            if (lastPost == Rounds && lastPop == Rounds)
                run.Board.Write("saw the last");
        };

        run.StartAndSettle();
        run.On(source, () =>
        {
            for (int i = 1; i <= Rounds; i++)
            {
                sender.Push(i);
                publisher.Value = i;
                publisher.Post();
            }
        });

        run.Until(() => run.Board.Count("saw the last") > 0, "the sink sees the last post and the last push");
    }

    [Fact, Trait("Clause", "1.5")]
    public void Causes_SeveralTogether_AreAllTold()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        QueueSender<int> sender = manager.Send<int>("queue", wakeOnPop: true);
        QueueReceiver<int> receiver = manager.Receive<int>("queue");

        run.StartAndSettle();
        run.On(manager, () =>
        {
            sender.Push(1);
            receiver.TryPop(out _);
            manager.WakeUp();
        });
        run.Until(() => manager.Units == 3, "the wakes cause one more run");

        Assert.Equal(WakeUpCauses.Push | WakeUpCauses.Pop | WakeUpCauses.Request, manager.Causes[2]);
    }

    [Fact, Trait("Clause", "1.5")]
    public void Causes_OutsideAUnit_AreNone()
    {
        var seen = new List<WakeUpCauses>();
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.OnStartup = () => seen.Add(manager.CausesNow);
        manager.OnShutdown = () => seen.Add(manager.CausesNow);

        run.StartAndSettle();
        run.Finish();

        Assert.Equal([WakeUpCauses.None, WakeUpCauses.None], seen);
    }

    [Fact, Trait("Clause", "1.6")]
    public void Stop_TimerOfDays_EndsAtOnce()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.WakeUpDelay = TimeSpan.FromDays(1000);

        run.StartAndSettle();
        ReactorResult result = run.Finish();

        Assert.Equal(ManagerOutcome.Ended, result.Managers[0].Outcome);
        Assert.Equal(0, result.ExitCode);
    }

    [Fact, Trait("Clause", "1.6")]
    public void Stop_FromAUnit_LetsTheUnitFinish()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        manager.OnUnit = () =>
        {
            manager.StopAll("enough");
            run.Board.Write("after the request");
        };

        run.Start();
        ReactorResult result = run.FinishByItself();

        Assert.Equal("m: enough", result.StopReason);
        Assert.Equal(["after the request"], run.Board.Entries);
        Assert.Equal(1, manager.Shutdowns);
    }

    [Fact, Trait("Clause", "1.6")]
    public void Stop_Twice_TheFirstReasonCounts()
    {
        using TestRun run = NewRun();
        run.Add("m");

        run.StartAndSettle();
        run.Reactor.Stop("first");

        Assert.Equal("first", run.Finish("second").StopReason);
    }

    private sealed class PlainManager() : RabitManager("plain")
    {
        protected override void ExecuteUnitOfWork()
        {
        }
    }
}

public sealed class ManagerInRealTime() : ManagerContract(TimeKind.Real);

public sealed class ManagerInVirtualTime() : ManagerContract(TimeKind.Virtual);
