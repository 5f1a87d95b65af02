using System;
using Rabit.Core.Messages;
using Rabit.Core.Tests.Time;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;
using Xunit;

namespace Rabit.Core.Tests.Messages;

/// <summary>Contract 2.3: versions, to their wrap-around and beyond.</summary>
public sealed class SharedMessageTests
{
    private static readonly EndpointOwner Poster = new("poster", isManager: true, new WakeUpEvent());

    [Theory, Trait("Clause", "2.3")]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(int.MaxValue - 2)]
    [InlineData(int.MaxValue)]
    [InlineData(int.MinValue)]
    [InlineData(-3)]
    [InlineData(-1)]
    public void Post_NearAnyVersion_IsNewsAndCountsWhatWasMissed(int start)
    {
        SharedValue<int> shared = New(start);
        LocalCopy<int> poster = shared.CreateCopy();
        LocalCopy<int> fetcher = shared.CreateCopy();
        poster.SeenVersion = start;
        fetcher.SeenVersion = start;

        for (int posts = 1; posts <= 6; posts++)
        {
            for (int i = 0; i < posts; i++)
            {
                poster.Value++;
                shared.Post(poster, Poster, TimeSpan.Zero);
                Assert.NotEqual(0, shared.Version);
            }

            Assert.Equal(posts, shared.Fetch(fetcher));
            Assert.Equal(poster.Value, fetcher.Value);
            Assert.Equal(poster.Stamp.Version, fetcher.Stamp.Version);
            Assert.Equal(0, shared.Fetch(fetcher));
        }
    }

    [Fact, Trait("Clause", "2.3")]
    public void Fetch_OfACopyThatNeverFetched_AfterTheSignHasTurned_IsNews()
    {
        SharedValue<int> shared = New(int.MinValue + 5);

        Assert.NotEqual(0, shared.Fetch(shared.CreateCopy()));
    }

    [Fact, Trait("Clause", "2.3")]
    public void TwoPosts_InOneTickOfAStandingClock_AreTwoPosts()
    {
        var clock = new ManualClock { Timestamp = 5 };
        var reactor = new RabitReactor(new ReactorOptions { Time = new RealTime(clock), StopsOnSignals = false });
        reactor.Add(new Idle());
        MessagePublisher<int> publisher = reactor.Workspace.Publish<int>("height");
        MessageSubscriber<int> subscriber = reactor.Workspace.Subscribe<int>("height");
        reactor.Start();

        publisher.Post();
        Assert.True(subscriber.Fetch());
        TimeSpan first = subscriber.Stamp.Time;
        publisher.Post();
        publisher.Post();
        Assert.True(subscriber.FetchAndCountMissed(out int missed));

        Assert.Equal(1, missed);
        Assert.Equal(first, subscriber.Stamp.Time);
        reactor.Stop();
        Assert.Equal(0, reactor.Finish().ExitCode);
    }

    [Fact, Trait("Clause", "2.3"), Trait("Clause", "5.1")]
    public void WallClock_SetBackAndForward_ChangesNothing()
    {
        var clock = new ManualClock();
        var reactor = new RabitReactor(new ReactorOptions { Time = new RealTime(clock), StopsOnSignals = false });
        reactor.Add(new Idle());
        MessagePublisher<int> publisher = reactor.Workspace.Publish<int>("height");
        MessageSubscriber<int> subscriber = reactor.Workspace.Subscribe<int>("height");
        reactor.Start();

        foreach (int year in new[] { 2030, 1980, 2020 })
        {
            clock.Utc = new DateTimeOffset(year, 1, 1, 0, 0, 0, TimeSpan.Zero);
            clock.Timestamp += TimeSpan.TicksPerSecond;
            publisher.Post();
            Assert.True(subscriber.FetchAndCountMissed(out int missed));
            Assert.Equal(0, missed);
            Assert.Equal(reactor.Now, subscriber.Stamp.Time);
            Assert.Equal(TimeSpan.Zero, subscriber.Age);
        }

        Assert.Equal(TimeSpan.FromSeconds(3), reactor.Now);
        clock.Timestamp += 7;
        Assert.Equal(TimeSpan.FromTicks(7), subscriber.Age);
        reactor.Stop();
        Assert.Equal(0, reactor.Finish().ExitCode);
    }

    // Four thousand million posts would take minutes.
    private static SharedValue<int> New(int version, bool isAlone = true, int tries = OptimisticRead.Tries)
        => new(MessagePlaces.New("height"), initial: 0, isAlone, version, tries);

    private sealed class Idle() : RabitManager("idle")
    {
        protected override void ExecuteUnitOfWork()
        {
        }
    }
}
