using System.Linq;
using System.Threading;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Messages;

/// <summary>
/// Contract 2.4 and 2.7 as a program has them, by the wiring of a reactor: with several publishers no post is lost.
/// </summary>
[Trait("Category", "Stress")]
public sealed class PublisherStressTests
{
    private const int Posts = 100_000;

    [Theory, Trait("Clause", "2.4"), Trait("Clause", "2.7")]
    [InlineData(2, 0)]
    [InlineData(1, 1)]
    [InlineData(2, 1)]
    public void Post_OfSeveralPublishersFlatOut_EachIsAVersion(int managers, int outside)
    {
        using var reactor = new RabitReactor(new ReactorOptions { StopsOnSignals = false });
        using var start = new Barrier(managers + outside);
        Poster[] posters = [.. Enumerable.Range(0, managers).Select(i => new Poster("poster " + i, start))];
        foreach (Poster poster in posters)
            reactor.Add(poster);
        MessageSubscriber<long> news = reactor.Workspace.Subscribe<long>("count");
        Thread[] others = [.. Enumerable.Range(0, outside).Select(_ => PosterOf(
            reactor.Workspace.Publish("count", 0L, allowOtherPublishers: true), start))];

        reactor.Start();
        foreach (Thread other in others)
            other.Start();
        foreach (Poster poster in posters)
            Assert.True(poster.HasPosted.Wait(TestTimeout.Limit), "the managers post");
        foreach (Thread other in others)
            Assert.True(other.Join(TestTimeout.Limit), "the others post");

        Assert.True(news.FetchAndCountMissed(out int missed));
        Assert.Equal(((managers + outside) * Posts) - 1, missed);
        reactor.Stop("enough");
        reactor.Finish();
    }

    /// <summary>One publisher, outside managers: it may go from thread to thread, one at a time.</summary>
    [Fact, Trait("Clause", "2.4")]
    public void Post_OfOnePublisherOutsideOnThreadsInTurn_EachIsAVersionAndFetchedWhole()
    {
        using var reactor = new RabitReactor(new ReactorOptions { StopsOnSignals = false });
        using var start = new Barrier(3);
        reactor.Add(new Idle());
        MessagePublisher<TestBlock> publisher = reactor.Workspace.Publish<TestBlock>("block");
        MessageSubscriber<TestBlock> counted = reactor.Workspace.Subscribe<TestBlock>("block");
        MessageSubscriber<TestBlock> fetched = reactor.Workspace.Subscribe<TestBlock>("block");
        reactor.Start();
        var turn = new object();
        long last = 0;
        Thread[] posters = [.. Enumerable.Range(0, 2).Select(_ => new Thread(() =>
        {
            start.SignalAndWait();
            for (int i = 0; i < Posts / 2; i++)
            {
                lock (turn)
                    publisher.Post(new TestBlock(++last));
            }
        }))];
        foreach (Thread poster in posters)
            poster.Start();
        start.SignalAndWait();
        long seen = 0;
        for (bool isLast = false; !isLast;)
        {
            isLast = !posters.Any(p => p.IsAlive);   // before the fetch: it finds the last post
            if (!fetched.Fetch())
                continue;
            Assert.True(fetched.Value.IsWhole);
            Assert.True(fetched.Value.Number > seen, "a fetch goes back");
            seen = fetched.Value.Number;
        }

        Assert.Equal(Posts, seen);
        Assert.True(counted.FetchAndCountMissed(out int missed));
        Assert.Equal(Posts - 1, missed);
        reactor.Stop("enough");
        reactor.Finish();
    }

    private static Thread PosterOf(MessagePublisher<long> publisher, Barrier start) => new(() =>
    {
        start.SignalAndWait();
        for (int i = 0; i < Posts; i++)
            publisher.Post(i);
    });

    private sealed class Idle() : RabitManager("idle")
    {
        protected override void ExecuteUnitOfWork()
        {
        }
    }

    private sealed class Poster : RabitManager
    {
        private readonly MessagePublisher<long> _publisher;
        private readonly Barrier _start;

        public Poster(string name, Barrier start)
            : base(name)
        {
            _publisher = Publish("count", 0L, allowOtherPublishers: true);
            _start = start;
            WakeUpDelay = Timeout.InfiniteTimeSpan;
        }

        public ManualResetEventSlim HasPosted { get; } = new();

        protected override void ExecuteUnitOfWork()
        {
            if (HasPosted.IsSet)
                return;
            _start.SignalAndWait();
            for (int i = 0; i < Posts; i++)
                _publisher.Post(i);
            HasPosted.Set();
        }
    }
}
