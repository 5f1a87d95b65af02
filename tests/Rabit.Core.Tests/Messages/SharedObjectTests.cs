using System;
using System.Threading;
using Rabit.Core.Messages;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Messages;

/// <summary>
/// Contract 1.8: who is held up while a class copies itself holds up no one else (a thread of a low priority that was
/// pushed off its processor stands there just so).
/// </summary>
public sealed class SharedObjectTests : IDisposable
{
    private static readonly EndpointOwner Manager = new("manager", isManager: true, new WakeUpEvent());
    private static readonly EndpointOwner Outside = new("outside", isManager: false, wakeUp: null);

    [ThreadStatic]
    private static bool _stops;

    private readonly ManualResetEventSlim _isInside = new();
    private readonly ManualResetEventSlim _goesOn = new();
    private readonly SharedObject<TestScan> _shared;
    private readonly LocalCopy<TestScan> _poster;
    private readonly LocalCopy<TestScan> _fetcher;

    public SharedObjectTests()
    {
        var first = new TestScan { OnCopy = StopInTheMiddle };
        _shared = new SharedObject<TestScan>(MessagePlaces.New("scan"), first);
        _poster = _shared.CreateCopy();
        _fetcher = _shared.CreateCopy();
    }

    public void Dispose()
    {
        _isInside.Dispose();
        _goesOn.Dispose();
    }

    [Fact, Trait("Clause", "2.3"), Trait("Clause", "2.5")]
    public void Post_AfterFetchesAndLooksAtTheStamp_MakesNoNewInstance()
    {
        int[] clones = [0];
        var shared = new SharedObject<Counted>(MessagePlaces.New("counted"), new Counted(clones));
        LocalCopy<Counted> poster = shared.CreateCopy();
        LocalCopy<Counted> fetcher = shared.CreateCopy();
        shared.Post(poster, Manager, TimeSpan.Zero);
        int before = clones[0];

        for (int i = 0; i < 20; i++)
        {
            shared.Post(poster, Manager, TimeSpan.Zero);
            shared.ReadStamp();
            shared.Fetch(fetcher);
        }

        Assert.Equal(before, clones[0]);
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "2.4")]
    public void Fetch_IsHeldUpInTheCopy_OthersPostAndFetch()
    {
        Post(1);
        LocalCopy<TestScan> slow = _shared.CreateCopy();
        Thread held = StartHeldUp(() => _shared.Fetch(slow));

        for (int number = 2; number <= 20; number++)
        {
            Post(number);
            Assert.Equal(number == 2 ? 2 : 1, _shared.Fetch(_fetcher));
            AssertHas(_fetcher, number);
        }

        Finish(held);
        AssertHas(slow, 1);
        Assert.Equal(19, _shared.Fetch(slow));
        AssertHas(slow, 20);
    }

    [Fact, Trait("Clause", "1.8"), Trait("Clause", "2.4")]
    public void Post_IsHeldUpInTheCopy_OthersPostAndFetch()
    {
        LocalCopy<TestScan> slow = _shared.CreateCopy();
        slow.Value.Fill(100);
        Thread held = StartHeldUp(() => _shared.Post(slow, Manager, TimeSpan.Zero));

        for (int number = 1; number <= 20; number++)
        {
            Post(number);
            Assert.Equal(1, _shared.Fetch(_fetcher));
            AssertHas(_fetcher, number);
        }

        Finish(held);
        Assert.Equal(1, _shared.Fetch(_fetcher));
        AssertHas(_fetcher, 100);
        Assert.Equal(21, _shared.Version);
    }

    [Fact]
    public void Post_OfOneOutsideEndpointByTwoThreads_IsAnErrorThatNamesTheMessage()
    {
        Thread held = StartHeldUp(() => _shared.Post(_poster, Outside, TimeSpan.Zero));

        InvalidOperationException error = Assert.Throws<InvalidOperationException>(
            () => _shared.Post(_poster, Outside, TimeSpan.Zero));

        Assert.Equal(
            "Two threads post message 'scan' at once through one endpoint: each needs an endpoint of its own.",
            error.Message);
        Finish(held);
        _shared.Post(_poster, Outside, TimeSpan.Zero);
        Assert.Equal(2, _shared.Version);
    }

    private static void AssertHas(LocalCopy<TestScan> copy, int number)
    {
        Assert.True(copy.Value.IsWhole);
        Assert.Equal(number, copy.Value.Number);
    }

    private void Post(int number)
    {
        _poster.Value.Fill(number);
        _shared.Post(_poster, Manager, TimeSpan.Zero);
    }

    private Thread StartHeldUp(Action work)
    {
        var thread = new Thread(() =>
        {
            _stops = true;
            work();
        })
        { IsBackground = true };
        thread.Start();
        Assert.True(_isInside.Wait(TestTimeout.Limit));
        return thread;
    }

    private void Finish(Thread held)
    {
        _goesOn.Set();
        Assert.True(held.Join(TestTimeout.Limit));
    }

    private void StopInTheMiddle()
    {
        if (!_stops)
            return;
        _isInside.Set();
        _goesOn.Wait();
    }

    private sealed class Counted(int[] clones) : ISelfCopying<Counted>
    {
        public Counted Clone()
        {
            clones[0]++;
            return new Counted(clones);
        }

        public void CopyTo(Counted target)
        {
            // It has no values of its own.
        }
    }
}
