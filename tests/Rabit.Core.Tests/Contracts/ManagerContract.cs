using System;
using System.Linq;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 1.1, 1.2, 1.5 and 1.6: the life of a manager, and what wakes it and stops it.</summary>
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

    [Fact, Trait("Clause", "4.5")]
    public void Doing_OfAnEarlierUnitOfWork_IsForgotten()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        run.OnAndSettle(manager, () => manager.Doing = "reading the scale");

        run.OnAndSettle(manager, () => Assert.Null(manager.Doing));
    }

    [Fact, Trait("Clause", "4.4")]
    public void LogRuns_Wanted_EachRunIsLoggedWithItsCauses()
    {
        using TestRun run = NewRun(options => options.LogRuns = true);
        ScriptedManager manager = run.Add("m");

        run.StartAndSettle();
        run.OnAndSettle(manager, () => { });
        run.Finish();

        Assert.Equal(
            ["runs, woken by Start", "runs, woken by Request"],
            run.Log.Where(e => e.Kind == RabitLogKind.Run).Select(e => e.Text));
    }
}

public sealed class ManagerInRealTime() : ManagerContract(TimeKind.Real);

public sealed class ManagerInVirtualTime() : ManagerContract(TimeKind.Virtual);
