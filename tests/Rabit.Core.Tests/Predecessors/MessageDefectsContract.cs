using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Predecessors;

/// <summary>
/// What publish-subscribe messages of the predecessors got wrong; the numbers are those of
/// docs/concepts/predecessors.md.
/// </summary>
public abstract class MessageDefectsContract(TimeKind kind) : ContractTests(kind)
{
    // There: subscribers were called while the message's mutex was held; one that posted or fetched could stand still
    // for ever.
    [Fact, Trait("Defect", "18")]
    public void Handlers_ThatPostToEachOther_DoNotStandStill()
    {
        using TestRun run = NewRun();
        ScriptedManager a = run.Add("a");
        ScriptedManager b = run.Add("b");
        MessagePublisher<int> left = a.Publish<int>("left");
        MessagePublisher<int> right = b.Publish<int>("right");
        MessageSubscriber<int> toLeft = b.Subscribe<int>("left", wakeOnPost: true);
        MessageSubscriber<int> toRight = a.Subscribe<int>("right", wakeOnPost: true);
        int handled = 0;
        toLeft.OnPost(_ => System.Threading.Interlocked.Increment(ref handled));
        toRight.OnPost(_ => System.Threading.Interlocked.Increment(ref handled));
        PlayBall(a, toRight, left, begins: true);
        PlayBall(b, toLeft, right, begins: false);

        run.Start();
        run.Until(() => System.Threading.Volatile.Read(ref handled) >= 1000, "the ball has gone to and fro");
    }

    // There: a stamp was read without the lock, half of it old and half of it new on 32-bit machines, and compared as a
    // time.
    [Fact, Trait("Defect", "19")]
    public void Fetch_StampsThatGoBackAndForth_FollowsThePosts()
    {
        using TestRun run = NewRun();
        (ScriptedManager poster, ScriptedManager fetcher, MessagePublisher<int> publisher,
            MessageSubscriber<int> subscriber) = Connect(run);

        run.StartAndSettle();
        foreach (int number in Enumerable.Range(1, 20))
        {
            TimeSpan stamp = TimeSpan.FromDays(number % 2 == 0 ? 1000 : -1000);
            run.On(poster, () =>
            {
                publisher.Value = number;
                publisher.PostStamped(stamp);
            });
            run.On(fetcher, () =>
            {
                Assert.True(subscriber.Fetch());
                Assert.Equal((number, stamp), (subscriber.Value, subscriber.Stamp.Time));
            });
        }
    }

    // There: the time was the version, and two posts within its resolution were one.
    [Fact, Trait("Defect", "20")]
    public void Fetch_ManyPostsWithOneStamp_MissesNone()
    {
        using TestRun run = NewRun();
        (ScriptedManager poster, ScriptedManager fetcher, MessagePublisher<int> publisher,
            MessageSubscriber<int> subscriber) = Connect(run);
        int news = 0;

        run.StartAndSettle();
        for (int i = 0; i < 100; i++)
        {
            run.On(poster, () => publisher.PostStamped(TimeSpan.FromSeconds(1)));
            run.On(fetcher, () => news += subscriber.FetchAndCountMissed(out int missed) ? 1 + missed : 0);
        }

        Assert.Equal(100, news);
    }

    // There: the copy of a copy held the original, so that a change of one changed all.
    [Fact, Trait("Defect", "21")]
    public void Post_ThenAChangeOfTheLocalCopy_LeavesWhatWasPosted()
    {
        using TestRun run = NewRun();
        (ScriptedManager poster, ScriptedManager fetcher, MessagePublisher<int> publisher,
            MessageSubscriber<int> subscriber) = Connect(run);

        run.StartAndSettle();
        run.On(poster, () =>
        {
            publisher.Value = 7;
            publisher.Post();
            publisher.Value = 8;
        });

        run.On(fetcher, () =>
        {
            Assert.True(subscriber.Fetch());
            Assert.Equal(7, subscriber.Value);
        });
    }

    // There: a message of another type than expected counted as connected, and the first use crashed.
    [Fact, Trait("Defect", "14")]
    public void Start_MessageOfTwoTypes_IsRefusedByName()
    {
        using TestRun run = NewRun();
        ScriptedManager a = run.Add("a");
        ScriptedManager b = run.Add("b");
        a.Publish<int>("number");
        b.Subscribe<double>("number");

        string text = Assert.Throws<RabitWiringException>(run.Start).Message;

        Assert.All(
            ["'number'", "'a'", "'b'", "Int32", "Double"],
            part => Assert.Contains(part, text, StringComparison.Ordinal));
    }

    // There: a message that existed was not found by its name, and one that did not was made of nothing and used.
    [Fact, Trait("Defect", "15")]
    public void Start_MessageWithoutAPublisher_IsRefusedByNameAndTheOthersAreFound()
    {
        using TestRun run = NewRun();
        ScriptedManager a = run.Add("a");
        ScriptedManager b = run.Add("b");
        a.Publish<int>("there");
        b.Subscribe<int>("there");
        b.Subscribe<int>("not there");

        string text = Assert.Throws<RabitWiringException>(run.Start).Message;

        Assert.Contains("'not there'", text, StringComparison.Ordinal);
        Assert.DoesNotContain("'there'", text, StringComparison.Ordinal);
    }

    // There (in C#): a post by name returned an error to its caller, whatever had come of it.
    [Fact, Trait("Defect", "C#")]
    public void Post_ByAnEndFromTheWorkspace_ArrivesAndSaysNothingElse()
    {
        using TestRun run = NewRun();
        ScriptedManager fetcher = run.Add("fetcher");
        MessageSubscriber<int> subscriber = fetcher.Subscribe<int>("number");
        MessagePublisher<int> publisher = run.Reactor.Workspace.Publish<int>("number");

        run.StartAndSettle();
        publisher.Value = 3;
        publisher.Post();

        run.On(fetcher, () =>
        {
            Assert.True(subscriber.Fetch());
            Assert.Equal(3, subscriber.Value);
        });
    }

    private static (ScriptedManager Poster, ScriptedManager Fetcher, MessagePublisher<int> Publisher,
        MessageSubscriber<int> Subscriber) Connect(TestRun run)
    {
        ScriptedManager poster = run.Add("poster");
        ScriptedManager fetcher = run.Add("fetcher");
        return (poster, fetcher, poster.Publish<int>("number"), fetcher.Subscribe<int>("number"));
    }

    private static void PlayBall(
        ScriptedManager player, MessageSubscriber<int> from, MessagePublisher<int> to, bool begins)
        => player.OnUnit = () =>
        {
            bool isTheFirst = begins && player.Units == 1;
            if (!from.Fetch() && !isTheFirst)
                return;

            // In virtual time the clock must move, or the run is taken for one that stands still.
            if (from.Value >= 1000)
                return;
            to.Value = from.Value + 1;
            to.Post();
        };
}

public sealed class MessageDefectsInRealTime() : MessageDefectsContract(TimeKind.Real);

public sealed class MessageDefectsInVirtualTime() : MessageDefectsContract(TimeKind.Virtual);
