using System;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Rabit.Core.Tests.Contracts;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Messages;

/// <summary>Contract 2.6: async code outside managers that waits for news.</summary>
public sealed class NewsTests : IDisposable
{
    private readonly RabitReactor _reactor;
    private readonly MessagePublisher<int> _publisher;
    private readonly MessageSubscriber<int> _subscriber;

    public NewsTests()
    {
        _reactor = new RabitReactor(new ReactorOptions { StopsOnSignals = false })
        {
            new ScriptedManager("m", new TestBoard()),
        };
        _publisher = _reactor.Workspace.Publish<int>("height");
        _subscriber = _reactor.Workspace.Subscribe<int>("height");
    }

    public void Dispose() => _reactor.Dispose();

    [Fact, Trait("Clause", "2.6")]
    public async Task WaitForNews_PostedBeforeOrAfter_ComesBackWithIt()
    {
        _reactor.Start();
        _publisher.Post(1);
        Assert.True(await _subscriber.WaitForNewsAsync());
        Assert.True(_subscriber.Fetch(out int value));
        Assert.Equal(1, value);

        Task<bool> news = _subscriber.WaitForNewsAsync();
        Assert.False(news.IsCompleted);
        _publisher.Post(2);
        Assert.True(await news);
    }

    [Fact, Trait("Clause", "2.6")]
    public void AsyncUse_OfAManagersEndpoint_IsRefusedAtTheCall()
    {
        var manager = new ScriptedManager("reader", new TestBoard());
        MessageSubscriber<int> own = manager.Subscribe<int>("height");
        _reactor.Add(manager);
        _reactor.Start();

        string[] texts =
        [
            Assert.Throws<InvalidOperationException>(() => { own.ReadAllAsync(); }).Message,
            Assert.Throws<InvalidOperationException>(() => { _ = own.WaitForNewsAsync(); }).Message,
        ];
        Assert.All(
            texts,
            t => Assert.EndsWith(
                "belongs to 'reader': async code gets an endpoint of its own from the workspace.", t,
                StringComparison.Ordinal));
    }

    [Fact, Trait("Clause", "2.6")]
    public async Task WaitForNews_CancelledBefore_IsCancelledAlthoughThereIsNews()
    {
        _reactor.Start();
        _publisher.Post(1);

        await Assert.ThrowsAnyAsync<OperationCanceledException>(
            () => _subscriber.WaitForNewsAsync(new CancellationToken(canceled: true)));
        Assert.True(_subscriber.Fetch());
    }

    [Fact, Trait("Clause", "2.6")]
    public async Task WaitForNews_TheRunEnds_ComesBackWithout()
    {
        _reactor.Start();
        Task<bool> news = _subscriber.WaitForNewsAsync();
        _reactor.Stop();
        _reactor.Finish();

        Assert.False(await news);
        Assert.False(await _subscriber.WaitForNewsAsync());
    }

    [Fact, Trait("Clause", "2.6")]
    public async Task WaitForNews_Cancelled_IsCancelledAndMayWaitAgain()
    {
        _reactor.Start();
        using var source = new CancellationTokenSource();
        Task<bool> news = _subscriber.WaitForNewsAsync(source.Token);
        source.Cancel();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => news);
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => _subscriber.WaitForNewsAsync(source.Token));

        news = _subscriber.WaitForNewsAsync();
        _publisher.Post(3);
        Assert.True(await news);
    }

    [Fact, Trait("Clause", "2.6")]
    public async Task ReadAll_WhileValuesArePosted_GivesTheLastOneAndEndsWithTheRun()
    {
        const int Posts = 20_000;
        var got = new List<int>();
        _reactor.Start();
        Task reading = Read();
        for (int i = 1; i <= Posts; i++)
            _publisher.Post(i);
        var timeout = new TestTimeout();
        while (Last() != Posts)
            Assert.True(timeout.TryWait(), $"the last post was lost: {Last()}");
        _reactor.Stop();
        _reactor.Finish();
        await reading;

        for (int i = 1; i < got.Count; i++)
            Assert.True(got[i] > got[i - 1]);

        async Task Read()
        {
            await foreach (int value in _subscriber.ReadAllAsync())
            {
                lock (got)
                    got.Add(value);
            }
        }

        int Last()
        {
            lock (got)
                return got.Count == 0 ? 0 : got[got.Count - 1];
        }
    }

    [Fact, Trait("Clause", "2.6")]
    public async Task ReadAll_OutsideCodePostsOnAfterTheEnd_EndsWithTheRun()
    {
        var got = new List<int>();
        _reactor.Start();
        _publisher.Post(1);
        await foreach (int value in _subscriber.ReadAllAsync())
        {
            got.Add(value);
            if (value == 1)
                End();
            if (value == 100)
                break;
            _publisher.Post(value + 1);
        }

        Assert.Equal([1], got);
    }

    [Fact, Trait("Clause", "2.6")]
    public async Task ReadAll_AfterTheEnd_GivesWhatWasPostedBeforeAndNoMore()
    {
        var got = new List<int>();
        _reactor.Start();
        _publisher.Post(1);
        _publisher.Post(2);
        End();
        await foreach (int value in _subscriber.ReadAllAsync())
        {
            got.Add(value);
            _publisher.Post(value + 1);
            if (got.Count == 100)
                break;
        }

        Assert.Equal([2], got);
    }

    [Fact, Trait("Clause", "2.6")]
    public async Task WaitForNews_PostedAfterTheEnd_ComesBackWithout()
    {
        _reactor.Start();
        _publisher.Post(1);
        End();
        Assert.True(await _subscriber.WaitForNewsAsync());
        Assert.True(await _subscriber.WaitForNewsAsync());

        // What was posted before it is no longer there. A fetch is what it is at any time: the latest value.
        _publisher.Post(2);
        Assert.False(await _subscriber.WaitForNewsAsync());
        Assert.True(_subscriber.Fetch(out int value));
        Assert.Equal(2, value);
        Assert.False(await _subscriber.WaitForNewsAsync());
        Assert.False(await _reactor.Workspace.Subscribe<int>("height").WaitForNewsAsync());
    }

    [Fact, Trait("Clause", "2.6"), Trait("Category", "Stress")]
    public async Task ReadAll_WhileOutsideCodePostsThroughTheEnd_Ends()
    {
        for (int round = 0; round < 20; round++)
        {
            using var test = new NewsTests();
            bool hasEnded = false;
            test._reactor.Start();
            Task reading = Task.Run(async () =>
            {
                await foreach (int value in test._subscriber.ReadAllAsync())
                    Assert.NotEqual(0, value);
            });
            var poster = new Thread(() =>
            {
                for (int i = 1; !Volatile.Read(ref hasEnded); i++)
                    test._publisher.Post(i);
            });
            poster.Start();
            Thread.SpinWait(50 * round);
            test.End();

            bool ends = await Task.WhenAny(reading, Task.Delay(TestTimeout.Limit)) == reading;
            Volatile.Write(ref hasEnded, true);
            Assert.True(poster.Join(TestTimeout.Limit));
            Assert.True(ends);
            await reading;
        }
    }

    [Fact, Trait("Clause", "2.6"), Trait("Clause", "2.8")]
    public void WaitForNews_OfAManagersEndpoint_IsAnErrorThatSaysSo()
    {
        using var run = new TestRun(TimeKind.Virtual);
        ScriptedManager manager = run.Add("pilot");
        MessageSubscriber<int> subscriber = manager.Subscribe<int>("height", optional: true);
        run.StartAndSettle();

        string text = Assert.Throws<InvalidOperationException>(() => { _ = subscriber.WaitForNewsAsync(); }).Message;
        Assert.Contains("'pilot'", text, StringComparison.Ordinal);
        Assert.Throws<InvalidOperationException>(() => subscriber.ReadAllAsync());
    }

    private void End()
    {
        _reactor.Stop();
        _reactor.Finish();
    }
}
