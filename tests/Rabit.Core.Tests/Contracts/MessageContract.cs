using System;
using System.Collections.Generic;
using System.Threading;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 2: the publish-subscribe message.</summary>
public abstract class MessageContract(TimeKind kind) : ContractTests(kind)
{
    [Fact, Trait("Clause", "2.1")]
    public void LocalCopies_Changed_NobodySeesItBeforePostAndFetch()
    {
        using Pair pair = Connect();
        pair.Run.On(pair.Poster, () => pair.Publisher.Value.Number = 7);
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.False(pair.Subscriber.Fetch());
            Assert.Equal(0, pair.Subscriber.Value.Number);
        });

        pair.Run.On(pair.Poster, pair.Publisher.Post);
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.Equal(0, pair.Subscriber.Value.Number);
            Assert.True(pair.Subscriber.Fetch());
            Assert.Equal(7, pair.Subscriber.Value.Number);
        });

        pair.Run.On(pair.Poster, () => pair.Publisher.Value.Number = 8);
        pair.Run.On(pair.Fetcher, () =>
        {
            pair.Subscriber.ForceFetch();
            Assert.Equal(7, pair.Subscriber.Value.Number);
        });
    }

    [Fact, Trait("Clause", "2.1")]
    public void BothEnds_OneManager_ShareOneLocalCopy()
    {
        using TestRun run = NewRun();
        ScriptedManager both = run.Add("both");
        ScriptedManager other = run.Add("other");
        MessagePublisher<Sample> publisher = both.Publish("sample", default(Sample), allowOtherPublishers: true);
        MessageSubscriber<Sample> subscriber = both.Subscribe<Sample>("sample");
        MessageSubscriber<Sample> second = both.Subscribe<Sample>("sample");
        MessagePublisher<Sample> others = other.Publish("sample", default(Sample), allowOtherPublishers: true);

        run.StartAndSettle();
        run.On(both, () =>
        {
            publisher.Value.Number = 1;
            Assert.Equal(1, subscriber.Value.Number);
            Assert.Equal(1, second.Value.Number);
        });
        run.On(other, () =>
        {
            others.Value.Number = 2;
            others.Post();
        });
        run.On(both, () =>
        {
            Assert.True(subscriber.Fetch());
            Assert.Equal(2, publisher.Value.Number);
            Assert.False(second.Fetch());
        });
    }

    [Fact, Trait("Clause", "2.2")]
    public void Fetch_AfterAPost_IsNewsOnce()
    {
        using Pair pair = Connect();
        pair.Run.On(pair.Poster, pair.Publisher.Post);
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.True(pair.Subscriber.Fetch());
            Assert.False(pair.Subscriber.Fetch());
            Assert.False(pair.Subscriber.ForceFetch());
        });
    }

    [Fact, Trait("Clause", "2.2")]
    public void ForceFetch_CopyCoveredByAnUnpostedChange_RestoresIt()
    {
        using TestRun run = NewRun();
        ScriptedManager both = run.Add("both");
        MessagePublisher<Sample> publisher = both.Publish("sample", new Sample { Number = 5 });
        MessageSubscriber<Sample> subscriber = both.Subscribe<Sample>("sample");

        run.StartAndSettle();
        run.On(both, () =>
        {
            publisher.Value.Number = 6;
            Assert.False(subscriber.Fetch());
            Assert.Equal(6, subscriber.Value.Number);
            Assert.False(subscriber.ForceFetch());
            Assert.Equal(5, subscriber.Value.Number);
        });
    }

    [Fact, Trait("Clause", "2.2")]
    public void OwnPost_Always_IsNoNewsToOneself()
    {
        using TestRun run = NewRun();
        ScriptedManager both = run.Add("both");
        MessagePublisher<Sample> publisher = both.Publish<Sample>("sample");
        MessageSubscriber<Sample> subscriber = both.Subscribe<Sample>("sample");

        run.StartAndSettle();
        run.On(both, () =>
        {
            publisher.Post();
            Assert.False(subscriber.Fetch(out int missed));
            Assert.Equal(0, missed);
            Assert.False(subscriber.ForceFetch());
            Assert.True(subscriber.WasPosted);
            Assert.Equal(1, subscriber.Stamp.Version);
        });
    }

    [Fact, Trait("Clause", "2.2")]
    public void BeforeTheFirstPost_InitialStated_EveryCopyHoldsItAndItIsNeverNews()
    {
        using TestRun run = NewRun();
        ScriptedManager poster = run.Add("poster");
        ScriptedManager fetcher = run.Add("fetcher");
        MessagePublisher<Sample> publisher = poster.Publish("sample", new Sample { Number = 3 });
        MessageSubscriber<Sample> subscriber = fetcher.Subscribe<Sample>("sample");

        run.StartAndSettle();
        run.On(poster, () => Assert.Equal(3, publisher.Value.Number));
        run.On(fetcher, () =>
        {
            Assert.Equal(3, subscriber.Value.Number);
            Assert.False(subscriber.WasPosted);
            Assert.False(subscriber.Fetch());
            Assert.False(subscriber.ForceFetch());
            Assert.Equal(0, subscriber.Stamp.Version);
            Assert.Equal(TimeSpan.MaxValue, subscriber.Age);
        });
        MessageSubscriber<Sample> late = run.Reactor.Workspace.Subscribe<Sample>("sample");
        Assert.Equal(3, late.Value.Number);
        Assert.False(late.Fetch());
    }

    [Fact, Trait("Clause", "2.2")]
    public void BeforeTheFirstPost_StructWithoutInitial_IsDefault()
    {
        using Pair pair = Connect();
        pair.Run.On(pair.Fetcher, () => Assert.Equal(0, pair.Subscriber.Value.Number));
    }

    [Fact, Trait("Clause", "2.2")]
    public void WasPosted_PostedAndNotFetched_IsTrue()
    {
        using Pair pair = Connect();
        pair.Run.On(pair.Poster, pair.Publisher.Post);
        pair.Run.On(pair.Fetcher, () => Assert.True(pair.Subscriber.WasPosted));
    }

    [Fact, Trait("Clause", "2.3")]
    public void TwoPosts_InOneUnit_AreTwoPosts()
    {
        using Pair pair = Connect();
        pair.Run.On(pair.Poster, () =>
        {
            pair.Publisher.Post(TimeSpan.FromSeconds(5));
            pair.Publisher.Post(TimeSpan.FromSeconds(5));
        });
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.True(pair.Subscriber.Fetch(out int missed));
            Assert.Equal(1, missed);
            Assert.Equal(2, pair.Subscriber.Stamp.Version);
        });
    }

    [Fact, Trait("Clause", "2.3")]
    public void Missed_PostsBetweenFetches_AreCountedAndResetByTheFetch()
    {
        using Pair pair = Connect();
        pair.Run.On(pair.Poster, () => Post(pair.Publisher, 4));
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.True(pair.Subscriber.Fetch(out int missed));
            Assert.Equal(3, missed);
        });
        pair.Run.On(pair.Poster, pair.Publisher.Post);
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.True(pair.Subscriber.Fetch(out int missed));
            Assert.Equal(0, missed);
            Assert.False(pair.Subscriber.Fetch(out missed));
            Assert.Equal(0, missed);
        });
    }

    [Fact, Trait("Clause", "2.3")]
    public void Missed_PostsOfOthersCoveredByOnesOwn_AreCountedWithTheNextNews()
    {
        using TestRun run = NewRun();
        ScriptedManager both = run.Add("both");
        ScriptedManager other = run.Add("other");
        MessagePublisher<Sample> publisher = both.Publish("sample", default(Sample), allowOtherPublishers: true);
        MessageSubscriber<Sample> subscriber = both.Subscribe<Sample>("sample");
        MessagePublisher<Sample> others = other.Publish("sample", default(Sample), allowOtherPublishers: true);

        run.StartAndSettle();
        run.On(other, () => Post(others, 2));
        run.On(both, () =>
        {
            publisher.Post();
            Assert.False(subscriber.Fetch(out int missed));
            Assert.Equal(0, missed);
        });
        run.On(other, others.Post);
        run.On(both, () =>
        {
            Assert.True(subscriber.Fetch(out int missed));
            Assert.Equal(2, missed);
        });
    }

    [Fact, Trait("Clause", "2.3")]
    public void Stamp_TimeNotGiven_IsTheTimeOfThePost()
    {
        using Pair pair = Connect();
        TimeSpan before = default;
        TimeSpan after = default;
        pair.Run.On(pair.Poster, () =>
        {
            before = pair.Poster.Time;
            pair.Publisher.Post();
            after = pair.Poster.Time;
        });
        pair.Run.On(pair.Fetcher, () =>
        {
            pair.Subscriber.Fetch();
            Assert.InRange(pair.Subscriber.Stamp.Time, before, after);
            Assert.InRange(pair.Subscriber.Age, TimeSpan.Zero, pair.Fetcher.Time - before);
        });
    }

    [Fact, Trait("Clause", "2.3")]
    public void Stamp_TimeGiven_IsThatTimeAndNewnessDoesNotDependOnIt()
    {
        using Pair pair = Connect();
        foreach (int seconds in new[] { 10, 3, 10, -5 })
        {
            var trueAt = TimeSpan.FromSeconds(seconds);
            pair.Run.On(pair.Poster, () => pair.Publisher.Post(trueAt));
            pair.Run.On(pair.Fetcher, () =>
            {
                Assert.True(pair.Subscriber.Fetch());
                Assert.Equal(trueAt, pair.Subscriber.Stamp.Time);
            });
        }
    }

    [Fact, Trait("Clause", "2.3")]
    public void IsFresh_AgainstAMaximumAge_GoesByTheStampOfWhatWasFetched()
    {
        using Pair pair = Connect();
        pair.Run.On(pair.Fetcher, () => Assert.False(pair.Subscriber.IsFresh(TimeSpan.MaxValue)));
        pair.Run.On(pair.Poster, () => pair.Publisher.Post(pair.Poster.Time - TimeSpan.FromSeconds(5)));
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.False(pair.Subscriber.IsFresh(TimeSpan.MaxValue));
            Assert.True(pair.Subscriber.Fetch());
            Assert.True(pair.Subscriber.IsFresh(TimeSpan.FromMinutes(10)));
            Assert.False(pair.Subscriber.IsFresh(TimeSpan.FromSeconds(4)));
            Assert.False(pair.Subscriber.IsFresh(TimeSpan.Zero));
            string told = Assert.Throws<ArgumentOutOfRangeException>(() => pair.Subscriber.IsFresh(TimeSpan.FromTicks(-1))).Message;
            Assert.Contains("'sample'", told, StringComparison.Ordinal);
        });
        pair.Run.On(pair.Poster, () => pair.Publisher.Post(pair.Poster.Time + TimeSpan.FromHours(1)));
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.False(pair.Subscriber.IsFresh(TimeSpan.Zero));
            Assert.True(pair.Subscriber.Fetch());
            Assert.True(pair.Subscriber.IsFresh(TimeSpan.Zero));
        });
    }

    [Fact, Trait("Clause", "2.5")]
    public void ImmutableClass_Posted_IsHandedOverByReference()
    {
        var plan = new Plan("survey");
        var next = new Plan("home");
        using TestRun run = NewRun();
        ScriptedManager poster = run.Add("poster");
        ScriptedManager fetcher = run.Add("fetcher");
        MessagePublisher<Plan> publisher = poster.Publish("plan", plan);
        MessageSubscriber<Plan> subscriber = fetcher.Subscribe<Plan>("plan");

        run.StartAndSettle();
        run.On(poster, () =>
        {
            publisher.Value = next;
            publisher.Post();
        });
        run.On(fetcher, () =>
        {
            Assert.Same(plan, subscriber.Value);
            Assert.True(subscriber.Fetch());
            Assert.Same(next, subscriber.Value);
        });
    }

    [Fact, Trait("Clause", "2.6")]
    public void Handler_AtAPost_RunsOnThePostersThreadWithTheStamp()
    {
        using Pair pair = Connect();
        int posterThread = 0;
        int handlerThread = 0;
        var stamps = new List<MessageStamp>();
        MessageSubscriber<Sample> outside = pair.Run.Reactor.Workspace.Subscribe<Sample>("sample");
        outside.OnPost(stamp =>
        {
            handlerThread = Environment.CurrentManagedThreadId;
            stamps.Add(stamp);
        });

        pair.Run.On(pair.Poster, () =>
        {
            posterThread = Environment.CurrentManagedThreadId;
            pair.Publisher.Post(TimeSpan.FromSeconds(9));
            Assert.Equal(1, Assert.Single(stamps).Version);
        });

        Assert.Equal(posterThread, handlerThread);
        Assert.Equal(TimeSpan.FromSeconds(9), stamps[0].Time);
    }

    [Fact, Trait("Clause", "2.6")]
    public void Handler_WhileItRuns_HoldsNoLock()
    {
        using Pair pair = Connect();
        bool fetched = false;
        MessageSubscriber<Sample> outside = pair.Run.Reactor.Workspace.Subscribe<Sample>("sample");
        outside.OnPost(_ =>
        {
            // Another thread fetches, and makes an end, while the handler waits for it: a lock held here would hold it up.
            var thread = new Thread(() => fetched = outside.ForceFetch() && pair.Run.Reactor.Workspace.Subscribe<Sample>("sample").Fetch());
            thread.Start();
            Assert.True(thread.Join(TimeSpan.FromSeconds(20)));
        });

        pair.Run.On(pair.Poster, pair.Publisher.Post);

        Assert.True(fetched);
    }

    [Fact, Trait("Clause", "2.6")]
    public void Handler_ThatThrows_HarmsNobodyAndIsReported()
    {
        using TestRun run = NewRun();
        ScriptedManager poster = run.Add("poster");
        ScriptedManager fetcher = run.Add("fetcher");
        MessagePublisher<Sample> publisher = poster.Publish<Sample>("sample");
        fetcher.Subscribe<Sample>("sample").OnPost(_ => throw new InvalidOperationException("boom"));
        fetcher.Subscribe<Sample>("sample").OnPost(_ => run.Board.Write("the second handler"));
        fetcher.Subscribe<Sample>("sample", wakeOnPost: true);

        run.StartAndSettle();
        run.OnAndSettle(poster, publisher.Post);
        run.Until(() => fetcher.Units == 2, "the post wakes the fetcher");
        Assert.Equal(0, run.Finish().ExitCode);

        Assert.Equal(["the second handler"], run.Board.Entries);
        RabitLogEntry entry = Assert.Single(run.Log, e => e.Kind == RabitLogKind.Fault);
        Assert.Equal("fetcher", entry.Source);
        Assert.Contains("'sample'", entry.Text, StringComparison.Ordinal);
        Assert.Contains("boom", entry.Text, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "2.6")]
    public void Handler_OfOnesOwnPost_IsNotCalled()
    {
        using TestRun run = NewRun();
        ScriptedManager both = run.Add("both");
        MessagePublisher<Sample> publisher = both.Publish<Sample>("sample");
        both.Subscribe<Sample>("sample").OnPost(_ => run.Board.Write("called"));

        run.StartAndSettle();
        run.On(both, publisher.Post);

        Assert.Empty(run.Board.Entries);
    }

    [Fact, Trait("Clause", "2.6"), Trait("Clause", "2.8")]
    public void Handler_ThatTouchesItsSubscribersEnds_IsReportedAsMisuse()
    {
        using TestRun run = NewRun();
        ScriptedManager poster = run.Add("poster");
        ScriptedManager fetcher = run.Add("fetcher");
        MessagePublisher<Sample> publisher = poster.Publish<Sample>("sample");
        MessageSubscriber<Sample> subscriber = fetcher.Subscribe<Sample>("sample");
        subscriber.OnPost(_ => subscriber.Fetch());

        run.StartAndSettle();
        run.On(poster, publisher.Post);

        RabitLogEntry entry = Assert.Single(run.Log, e => e.Kind == RabitLogKind.Fault);
        Assert.Contains("'fetcher'", entry.Text, StringComparison.Ordinal);
        Assert.Contains("'poster'", entry.Text, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "2.7")]
    public void Publishers_TwoUndeclared_AreAnErrorAtStartByName()
    {
        using TestRun run = NewRun();
        run.Add("one").Publish<int>("height");
        run.Add("two").Publish("height", 0, allowOtherPublishers: true);

        string fault = Assert.Single(Assert.Throws<RabitWiringException>(run.Start).Faults);

        Assert.Contains("'height'", fault, StringComparison.Ordinal);
        Assert.Contains("'one'", fault, StringComparison.Ordinal);
        Assert.Contains("'two'", fault, StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "2.7")]
    public void Publishers_TwoThatAllowEachOther_BothPost()
    {
        using TestRun run = NewRun();
        ScriptedManager one = run.Add("one");
        ScriptedManager two = run.Add("two");
        MessagePublisher<int> first = one.Publish("height", 0, allowOtherPublishers: true);
        MessagePublisher<int> second = two.Publish("height", 0, allowOtherPublishers: true);
        MessageSubscriber<int> subscriber = run.Reactor.Workspace.Subscribe<int>("height");

        run.StartAndSettle();
        run.On(one, () => PostValue(first, 1));
        Assert.True(subscriber.Fetch());
        Assert.Equal(1, subscriber.Value);
        run.On(two, () => PostValue(second, 2));
        Assert.True(subscriber.Fetch());
        Assert.Equal(2, subscriber.Value);
    }

    [Fact, Trait("Clause", "2.8")]
    public void End_UsedByAnotherManager_IsAnErrorThatNamesBoth()
    {
        using Pair pair = Connect();
        Action[] misuses =
        [
            () => pair.Subscriber.Fetch(),
            () => pair.Subscriber.Fetch(out _),
            () => pair.Subscriber.ForceFetch(),
            () => _ = pair.Subscriber.Value,
            () => _ = pair.Subscriber.Age,
            () => pair.Subscriber.IsFresh(TimeSpan.Zero),
            () => _ = pair.Subscriber.Stamp,
            () => _ = pair.Subscriber.WasPosted,
        ];
        pair.Run.On(pair.Poster, () =>
        {
            foreach (Action misuse in misuses)
                AssertMisuse(misuse, "'sample'", "'fetcher'", "'poster'");
        });
        pair.Run.On(pair.Fetcher, () =>
        {
            AssertMisuse(pair.Publisher.Post, "'sample'", "'fetcher'", "'poster'");
            AssertMisuse(() => pair.Publisher.Post(TimeSpan.Zero), "'sample'", "'fetcher'", "'poster'");
            AssertMisuse(() => pair.Publisher.Value = default, "'sample'", "'fetcher'", "'poster'");
        });
    }

    [Fact, Trait("Clause", "2.8")]
    public void End_UsedOutsideManagers_IsAnErrorThatNamesItsOwner()
    {
        using Pair pair = Connect();
        AssertMisuse(() => pair.Subscriber.Fetch(), "'sample'", "'fetcher'", "no manager");
        AssertMisuse(pair.Publisher.Post, "'sample'", "'poster'", "no manager");
    }

    [Fact, Trait("Clause", "2.8")]
    public void End_UsedBeforeTheStart_IsAnErrorThatNamesItsOwner()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        MessagePublisher<int> publisher = manager.Publish<int>("height");
        MessageSubscriber<int> outside = run.Reactor.Workspace.Subscribe<int>("height");

        AssertMisuse(publisher.Post, "'height'", "'m'", "before");
        AssertMisuse(() => outside.Fetch(), "'height'", "'outside'", "before");
    }

    [Fact, Trait("Clause", "2.8")]
    public void Ends_InStartupAndShutdown_MayBeUsed()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        MessagePublisher<int> publisher = manager.Publish<int>("height");
        MessageSubscriber<int> outside = run.Reactor.Workspace.Subscribe<int>("height");
        manager.OnStartup = publisher.Post;
        manager.OnShutdown = publisher.Post;

        run.Start();
        Assert.Equal(0, run.Finish().ExitCode);

        Assert.True(outside.Fetch(out int missed));
        Assert.Equal(1, missed);
    }

    [Fact, Trait("Clause", "2.8")]
    public void OutsideEnds_AreOwnersOfTheirOwn()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        MessageSubscriber<int> inside = manager.Subscribe<int>("order", wakeOnPost: true);
        MessagePublisher<int> publisher = run.Reactor.Workspace.Publish<int>("order");
        MessageSubscriber<int> early = run.Reactor.Workspace.Subscribe<int>("order");

        run.StartAndSettle();
        MessageSubscriber<int> late = run.Reactor.Workspace.Subscribe<int>("order");
        PostValue(publisher, 4);
        run.Until(() => manager.Units == 2, "the post wakes the manager");

        Assert.True(early.Fetch());
        Assert.True(late.Fetch());
        Assert.Equal(4, late.Value);
        run.On(manager, () =>
        {
            Assert.True(inside.Fetch());
            Assert.Equal(4, inside.Value);
        });
        Assert.Throws<InvalidOperationException>(() => run.Reactor.Workspace.Publish<int>("late"));
        Assert.Throws<InvalidOperationException>(() => run.Reactor.Workspace.Send<int>("late"));
        Assert.Contains("'ordre'", Assert.Throws<InvalidOperationException>(() => run.Reactor.Workspace.Subscribe<int>("ordre")).Message, StringComparison.Ordinal);
        Assert.Contains("Int64", Assert.Throws<InvalidOperationException>(() => run.Reactor.Workspace.Subscribe<long>("order")).Message, StringComparison.Ordinal);
    }

    private static void AssertMisuse(Action misuse, params string[] names)
    {
        string text = Assert.Throws<InvalidOperationException>(misuse).Message;
        Assert.All(names, name => Assert.Contains(name, text, StringComparison.Ordinal));
    }

    private static void Post(MessagePublisher<Sample> publisher, int times)
    {
        for (int i = 0; i < times; i++)
            publisher.Post();
    }

    private static void PostValue(MessagePublisher<int> publisher, int value)
    {
        publisher.Value = value;
        publisher.Post();
    }

    private Pair Connect() => new(NewRun());

    private struct Sample
    {
        public int Number;
    }

    private sealed class Plan(string name)
    {
        public string Name { get; } = name;
    }

    /// <summary>One manager that posts a sample and one that fetches it.</summary>
    private sealed class Pair : IDisposable
    {
        public Pair(TestRun run)
        {
            Run = run;
            Poster = run.Add("poster");
            Fetcher = run.Add("fetcher");
            Publisher = Poster.Publish<Sample>("sample");
            Subscriber = Fetcher.Subscribe<Sample>("sample");
            run.StartAndSettle();
        }

        public TestRun Run { get; }

        public ScriptedManager Poster { get; }

        public ScriptedManager Fetcher { get; }

        public MessagePublisher<Sample> Publisher { get; }

        public MessageSubscriber<Sample> Subscriber { get; }

        public void Dispose() => Run.Dispose();
    }
}

public sealed class MessageInRealTime() : MessageContract(TimeKind.Real);

public sealed class MessageInVirtualTime() : MessageContract(TimeKind.Virtual);
