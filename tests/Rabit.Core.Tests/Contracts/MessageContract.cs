using System;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 2.1 to 2.5: copies, posts, fetches, stamps.</summary>
public abstract class MessageContract(TimeKind kind) : ContractTests(kind)
{
    [Fact, Trait("Clause", "2.1")]
    public void LocalCopies_Changed_NoManagerSeesItBeforePostAndFetch()
    {
        using MessagePair pair = Connect();
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

    [Fact, Trait("Clause", "2.2")]
    public void PostOfAValue_AndFetchOfAValue_GoThroughTheLocalCopies()
    {
        using MessagePair pair = Connect();
        pair.Run.On(pair.Poster, () =>
        {
            pair.Publisher.Post(new Sample { Number = 7 });
            Assert.Equal(7, pair.Publisher.Value.Number);
        });
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.True(pair.Subscriber.Fetch(out Sample news));
            Assert.False(pair.Subscriber.Fetch(out Sample same));
            Assert.Equal((7, 7, 7), (news.Number, same.Number, pair.Subscriber.Value.Number));

            news.Number = 8;
            Assert.Equal(7, pair.Subscriber.Value.Number);
        });
    }

    [Fact, Trait("Clause", "2.2"), Trait("Clause", "2.3")]
    public void PostStampedOfAValue_Always_HasValueAndTime()
    {
        using MessagePair pair = Connect();
        pair.Run.On(pair.Poster, () => pair.Publisher.PostStamped(new Sample { Number = 7 }, TimeSpan.FromSeconds(-5)));
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.True(pair.Subscriber.Fetch(out Sample news));
            Assert.Equal((7, TimeSpan.FromSeconds(-5)), (news.Number, pair.Subscriber.Stamp.Time));
        });
    }

    // The overloads must not be mistaken for those that take a time or return a count.
    [Fact, Trait("Clause", "2.2")]
    public void PostAndFetchOfAValue_NumbersAndTimes_AreTheValue()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        MessagePublisher<int> number = manager.Publish<int>("number");
        MessagePublisher<TimeSpan> time = manager.Publish<TimeSpan>("time");
        MessageSubscriber<int> numbers = run.Reactor.Workspace.Subscribe<int>("number");
        MessageSubscriber<TimeSpan> times = run.Reactor.Workspace.Subscribe<TimeSpan>("time");

        run.StartAndSettle();
        run.On(manager, () =>
        {
            number.Post(42);
            time.Post(TimeSpan.FromHours(3));
        });

        Assert.True(numbers.Fetch(out int fetchedNumber));
        Assert.True(times.Fetch(out TimeSpan fetchedTime));
        Assert.Equal((42, TimeSpan.FromHours(3)), (fetchedNumber, fetchedTime));
        Assert.InRange(times.Stamp.Time, TimeSpan.Zero, run.Reactor.Now);
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
        using MessagePair pair = Connect();
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
            Assert.False(subscriber.FetchAndCountMissed(out int missed));
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
        using MessagePair pair = Connect();
        pair.Run.On(pair.Fetcher, () => Assert.Equal(0, pair.Subscriber.Value.Number));
    }

    [Fact, Trait("Clause", "2.2")]
    public void WasPosted_PostedAndNotFetched_IsTrue()
    {
        using MessagePair pair = Connect();
        pair.Run.On(pair.Poster, pair.Publisher.Post);
        pair.Run.On(pair.Fetcher, () => Assert.True(pair.Subscriber.WasPosted));
    }

    [Fact, Trait("Clause", "2.3")]
    public void TwoPosts_InOneUnit_AreTwoPosts()
    {
        using MessagePair pair = Connect();
        pair.Run.On(pair.Poster, () =>
        {
            pair.Publisher.PostStamped(TimeSpan.FromSeconds(5));
            pair.Publisher.PostStamped(TimeSpan.FromSeconds(5));
        });
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.True(pair.Subscriber.FetchAndCountMissed(out int missed));
            Assert.Equal(1, missed);
            Assert.Equal(2, pair.Subscriber.Stamp.Version);
        });
    }

    [Fact, Trait("Clause", "2.3")]
    public void Missed_PostsBetweenFetches_AreCountedAndResetByTheFetch()
    {
        using MessagePair pair = Connect();
        pair.Run.On(pair.Poster, () => Post(pair.Publisher, 4));
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.True(pair.Subscriber.FetchAndCountMissed(out int missed));
            Assert.Equal(3, missed);
        });
        pair.Run.On(pair.Poster, pair.Publisher.Post);
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.True(pair.Subscriber.FetchAndCountMissed(out int missed));
            Assert.Equal(0, missed);
            Assert.False(pair.Subscriber.FetchAndCountMissed(out missed));
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
            Assert.False(subscriber.FetchAndCountMissed(out int missed));
            Assert.Equal(0, missed);
        });
        run.On(other, others.Post);
        run.On(both, () =>
        {
            Assert.True(subscriber.FetchAndCountMissed(out int missed));
            Assert.Equal(2, missed);
        });
    }

    [Fact, Trait("Clause", "2.3")]
    public void Stamp_TimeNotGiven_IsTheTimeOfThePost()
    {
        using MessagePair pair = Connect();
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
        using MessagePair pair = Connect();
        foreach (int seconds in new[] { 10, 3, 10, -5 })
        {
            var trueAt = TimeSpan.FromSeconds(seconds);
            pair.Run.On(pair.Poster, () => pair.Publisher.PostStamped(trueAt));
            pair.Run.On(pair.Fetcher, () =>
            {
                Assert.True(pair.Subscriber.Fetch());
                Assert.Equal(trueAt, pair.Subscriber.Stamp.Time);
            });
        }
    }

    [Fact, Trait("Clause", "2.3")]
    public void IsFresh_StampInTheFuture_IsFalse()
    {
        using MessagePair pair = Connect();
        pair.Run.On(pair.Poster, () => pair.Publisher.PostStamped(pair.Poster.Time + TimeSpan.FromDays(365)));

        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.True(pair.Subscriber.Fetch());
            Assert.True(pair.Subscriber.Age < TimeSpan.Zero);
            Assert.False(pair.Subscriber.IsFresh(TimeSpan.FromSeconds(1)));
            Assert.False(pair.Subscriber.IsFresh(TimeSpan.MaxValue));
        });
    }

    [Fact, Trait("Clause", "2.3")]
    public void IsFresh_AgainstAMaximumAge_GoesByTheStampOfWhatWasFetched()
    {
        using MessagePair pair = Connect();
        pair.Run.On(pair.Fetcher, () => Assert.False(pair.Subscriber.IsFresh(TimeSpan.MaxValue)));
        pair.Run.On(pair.Poster, () => pair.Publisher.PostStamped(pair.Poster.Time - TimeSpan.FromSeconds(5)));
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.False(pair.Subscriber.IsFresh(TimeSpan.MaxValue));
            Assert.True(pair.Subscriber.Fetch());
            Assert.True(pair.Subscriber.IsFresh(TimeSpan.FromMinutes(10)));
            Assert.False(pair.Subscriber.IsFresh(TimeSpan.FromSeconds(4)));
            Assert.False(pair.Subscriber.IsFresh(TimeSpan.Zero));
            string message = Assert.Throws<ArgumentOutOfRangeException>(
                () => pair.Subscriber.IsFresh(TimeSpan.FromTicks(-1))).Message;
            Assert.Contains("'sample'", message, StringComparison.Ordinal);
        });
        if (Kind.HasThreads)
            return;

        // Where the clock stands still a value has the age zero.
        pair.Run.On(pair.Poster, pair.Publisher.Post);
        pair.Run.On(pair.Fetcher, () =>
        {
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

    private static void Post(MessagePublisher<Sample> publisher, int times)
    {
        for (int i = 0; i < times; i++)
            publisher.Post();
    }

    private MessagePair Connect() => new(NewRun());

    private sealed class Plan(string name)
    {
        public string Name { get; } = name;
    }
}

public sealed class MessageInRealTime() : MessageContract(TimeKind.Real);

public sealed class MessageInVirtualTime() : MessageContract(TimeKind.Virtual);
