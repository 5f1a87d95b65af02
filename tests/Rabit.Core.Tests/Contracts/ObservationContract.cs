using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Tests.Messages;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 2.1, 2.2, 3.1, 4.2: messages and queues as tools see them that know them by name only.</summary>
public abstract class ObservationContract(TimeKind kind) : ContractTests(kind)
{
    [Fact, Trait("Clause", "4.2")]
    public void Observe_BeforeTheStart_IsEmptyAndLaterAllByName()
    {
        using TestRun run = NewRun(o => o.Name = "line 3");
        ScriptedManager one = run.Add("one");
        ScriptedManager two = run.Add("two");
        one.Publish<Sample>("sample");
        two.Receive<int>("queue", capacity: 4);
        one.Send<int>("queue");
        Assert.Equal("line 3", run.Reactor.Name);
        Assert.Empty(run.Reactor.Workspace.ObserveMessages());
        Assert.Empty(run.Reactor.Workspace.ObserveQueues());

        run.StartAndSettle();

        Assert.Equal(
            [("one/status", typeof(ManagerStatus)), ("sample", typeof(Sample)), ("two/status", typeof(ManagerStatus))],
            run.Reactor.Workspace.ObserveMessages().Select(m => (m.Name, m.ValueType)));
        QueueObserver queue = Assert.Single(run.Reactor.Workspace.ObserveQueues());
        Assert.Equal(("queue", typeof(int)), (queue.Name, queue.ValueType));
    }

    [Fact, Trait("Clause", "2.1"), Trait("Clause", "2.2")]
    public void ReadValue_OfAStruct_IsACopyWithItsStampThatNoPostChanges()
    {
        using var pair = new MessagePair(NewRun());
        MessageObserver observer = Find(pair.Run, "sample");
        Assert.Equal(0, observer.ReadStamp().Version);
        Assert.Equal(0, ((Sample)observer.ReadValue(out MessageStamp none)!).Number);
        Assert.Equal(0, none.Version);

        Post(pair, 7, TimeSpan.FromSeconds(3));
        object first = observer.ReadValue(out MessageStamp stamp)!;
        Post(pair, 8, TimeSpan.FromSeconds(4));

        Assert.Equal((7, 1, TimeSpan.FromSeconds(3)), (((Sample)first).Number, stamp.Version, stamp.Time));
        Assert.Equal((2, TimeSpan.FromSeconds(4)), (observer.ReadStamp().Version, observer.ReadStamp().Time));
        Assert.Equal(8, ((Sample)observer.ReadValue(out _)!).Number);
    }

    [Fact, Trait("Clause", "2.1"), Trait("Clause", "4.2")]
    public void ReadValue_BetweenPostAndFetch_TakesNoNewsAndIsInNoWiring()
    {
        using var pair = new MessagePair(NewRun());
        string wiring = pair.Run.Reactor.Workspace.DescribeWiring();
        MessageObserver observer = Find(pair.Run, "sample");
        Post(pair, 7, TimeSpan.Zero);
        observer.ReadValue(out _);

        pair.Run.On(pair.Fetcher, () => Assert.True(pair.Subscriber.Fetch()));
        Assert.Equal(wiring, pair.Run.Reactor.Workspace.DescribeWiring());
    }

    [Fact, Trait("Clause", "2.2")]
    public void ReadValue_OfAnImmutableClass_IsThePostedObject()
    {
        using TestRun run = NewRun();
        ScriptedManager poster = run.Add("poster");
        MessagePublisher<string> publisher = poster.Publish("text", "none");
        run.StartAndSettle();
        Assert.Equal("none", Find(run, "text").ReadValue(out _));

        run.On(poster, () => publisher.Post("some"));

        Assert.Equal("some", Find(run, "text").ReadValue(out MessageStamp stamp));
        Assert.Equal(1, stamp.Version);
    }

    [Fact, Trait("Clause", "2.5")]
    public void Read_OfASelfCopyingClass_CopiesForTheValueAndNotForTheStamp()
    {
        using TestRun run = NewRun();
        ScriptedManager poster = run.Add("poster");
        MessagePublisher<TestScan> publisher = poster.Publish("scan", TestScan.Filled(3));
        run.StartAndSettle();
        MessageObserver observer = Find(run, "scan");
        run.On(poster, () =>
        {
            publisher.Value.Fill(7);
            publisher.PostStamped(TimeSpan.FromSeconds(2));
            publisher.Value.Fill(8);
        });

        Assert.Equal((1, TimeSpan.FromSeconds(2)), (observer.ReadStamp().Version, observer.ReadStamp().Time));
        var scan = (TestScan)observer.ReadValue(out MessageStamp stamp)!;
        Assert.True(scan.IsWhole);
        Assert.Equal((7, 1), (scan.Number, stamp.Version));
        run.On(poster, () => Assert.NotSame(scan, publisher.Value));
    }

    [Fact, Trait("Clause", "3.1")]
    public void ReadCounters_OfEveryRule_AreThoseOfTheQueueAfterTheRunToo()
    {
        foreach (QueueFullMode rule in new[] { QueueFullMode.Reject, QueueFullMode.DropOldest })
        {
            using var pair = new QueuePair(NewRun(), capacity: 2, rule, wakeOnPush: false, wakeOnPop: false);
            QueueObserver queue = Assert.Single(pair.Run.Reactor.Workspace.ObserveQueues());
            pair.Run.On(pair.Source, () =>
            {
                for (int i = 0; i < 3; i++)
                    pair.Sender.Push(i);
            });

            QueueCounters counters = queue.ReadCounters();
            pair.Run.Finish();

            Assert.Equal((2, 2, 2), (counters.Resident, counters.HighWater, counters.Capacity));
            Assert.Equal(1, counters.Dropped + counters.Rejected);
            Assert.Equal(counters.ToString(), queue.ReadCounters().ToString());
        }
    }

    private static MessageObserver Find(TestRun run, string name)
    {
        IReadOnlyList<MessageObserver> all = run.Reactor.Workspace.ObserveMessages();
        return all.Single(m => m.Name == name);
    }

    private static void Post(MessagePair pair, int number, TimeSpan time)
        => pair.Run.On(pair.Poster, () => pair.Publisher.PostStamped(new Sample { Number = number }, time));
}

public sealed class ObservationInRealTime() : ObservationContract(TimeKind.Real);

public sealed class ObservationInVirtualTime() : ObservationContract(TimeKind.Virtual);
