using System.Collections.Generic;
using System.Linq;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 1.4 and 1.5: wake-ups do not stack, none is lost, and their causes are reported.</summary>
public abstract class WakeUpContract(TimeKind kind) : ContractTests(kind)
{
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
            () => run.StatusOf(sleeper).WakeUps is var w && w.Request + w.Merged == Wakes,
            "every wake causes a run or merges with another");

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
    public void Causes_SeveralTogether_AreAllReported()
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
}

public sealed class WakeUpInRealTime() : WakeUpContract(TimeKind.Real);

public sealed class WakeUpInVirtualTime() : WakeUpContract(TimeKind.Virtual);
