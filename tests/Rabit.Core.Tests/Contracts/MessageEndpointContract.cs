using System;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 2.7 and 2.8: who publishes, and who may use an end.</summary>
public abstract class MessageEndpointContract(TimeKind kind) : ContractTests(kind)
{
    [Fact]
    public void Age_OfTheExtremesOfTime_ThrowsNothing()
    {
        using MessagePair pair = Connect();
        pair.Run.On(pair.Poster, () => pair.Publisher.PostStamped(TimeSpan.MinValue));
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.True(pair.Subscriber.Fetch());
            Assert.Equal(TimeSpan.MaxValue, pair.Subscriber.Age);
            Assert.False(pair.Subscriber.IsFresh(TimeSpan.FromDays(1000)));
        });
        pair.Run.On(pair.Poster, () => pair.Publisher.PostStamped(TimeSpan.MaxValue));
        pair.Run.On(pair.Fetcher, () =>
        {
            Assert.True(pair.Subscriber.Fetch());
            Assert.True(pair.Subscriber.Age < TimeSpan.FromDays(-10_000));
            Assert.False(pair.Subscriber.IsFresh(TimeSpan.MaxValue));
        });
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
        using MessagePair pair = Connect();
        Action[] misuses =
        [
            () => pair.Subscriber.Fetch(),
            () => pair.Subscriber.Fetch(out Sample _),
            () => pair.Subscriber.FetchAndCountMissed(out _),
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
            AssertMisuse(() => pair.Publisher.PostStamped(TimeSpan.Zero), "'sample'", "'fetcher'", "'poster'");
            AssertMisuse(() => pair.Publisher.Post(default(Sample)), "'sample'", "'fetcher'", "'poster'");
            AssertMisuse(() => pair.Publisher.PostStamped(default, TimeSpan.Zero), "'sample'", "'fetcher'", "'poster'");
            AssertMisuse(() => pair.Publisher.Value = default, "'sample'", "'fetcher'", "'poster'");
        });
    }

    [Fact, Trait("Clause", "2.8")]
    public void End_UsedOutsideManagers_IsAnErrorThatNamesItsOwner()
    {
        using MessagePair pair = Connect();
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

        Assert.True(outside.FetchAndCountMissed(out int missed));
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
        Assert.Contains(
            "'ordre'",
            Assert.Throws<InvalidOperationException>(() => run.Reactor.Workspace.Subscribe<int>("ordre")).Message,
            StringComparison.Ordinal);
        Assert.Contains(
            "Int64",
            Assert.Throws<InvalidOperationException>(() => run.Reactor.Workspace.Subscribe<long>("order")).Message,
            StringComparison.Ordinal);
    }

    [Fact, Trait("Clause", "2.2"), Trait("Clause", "2.8")]
    public void OutsidePublisher_FirstValueStated_IsWhatASubscriberHoldsUntilItPosts()
    {
        using TestRun run = NewRun();
        ScriptedManager manager = run.Add("m");
        MessageSubscriber<string> subscriber = manager.Subscribe<string>("order");
        MessagePublisher<string> publisher = run.Reactor.Workspace.Publish("order", "wait");

        run.StartAndSettle();
        run.On(manager, () => Assert.Equal((false, "wait"), (subscriber.Fetch(), subscriber.Value)));
        publisher.Value = "go";
        publisher.Post();

        run.On(manager, () => Assert.Equal((true, "go"), (subscriber.Fetch(), subscriber.Value)));
    }

    private static void AssertMisuse(Action misuse, params string[] names)
    {
        string text = Assert.Throws<InvalidOperationException>(misuse).Message;
        Assert.All(names, name => Assert.Contains(name, text, StringComparison.Ordinal));
    }

    private static void PostValue(MessagePublisher<int> publisher, int value)
    {
        publisher.Value = value;
        publisher.Post();
    }

    private MessagePair Connect() => new(NewRun());
}

public sealed class MessageEndInRealTime() : MessageEndpointContract(TimeKind.Real);

public sealed class MessageEndInVirtualTime() : MessageEndpointContract(TimeKind.Virtual);
