using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Threading;
using Rabit.Tests.Shared;
using Xunit;

namespace Rabit.Core.Tests.Contracts;

/// <summary>Contract 2.6: handlers of posts.</summary>
public abstract class PostHandlerContract(TimeKind kind) : ContractTests(kind)
{
    [Fact, Trait("Clause", "2.6")]
    public void Handler_AtAPost_RunsOnThePostersThreadWithTheStamp()
    {
        using MessagePair pair = Connect();
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
            pair.Publisher.PostStamped(TimeSpan.FromSeconds(9));
            Assert.Equal(1, Assert.Single(stamps).Version);
        });

        Assert.Equal(posterThread, handlerThread);
        Assert.Equal(TimeSpan.FromSeconds(9), stamps[0].Time);
    }

    [Fact, Trait("Clause", "2.6")]
    public void Handler_WhileItRuns_HoldsNoLock()
    {
        using MessagePair pair = Connect();
        bool fetched = false;
        MessageSubscriber<Sample> outside = pair.Run.Reactor.Workspace.Subscribe<Sample>("sample");
        outside.OnPost(_ =>
        {
            // Another thread fetches, and makes an end, while the handler waits for it: a lock held here would hold it
            // up.
            var thread = new Thread(
                () => fetched = outside.ForceFetch() && pair.Run.Reactor.Workspace.Subscribe<Sample>("sample").Fetch());
            thread.Start();
            Assert.True(thread.Join(TestTimeout.Limit));
        });

        pair.Run.On(pair.Poster, pair.Publisher.Post);

        Assert.True(fetched);
    }

    [Fact, Trait("Clause", "2.6")]
    public void Handler_ThatThrows_HarmsNoManagerAndIsReported()
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

    [Fact, Trait("Clause", "2.6")]
    public void Subscription_Disposed_IsCalledNoMore()
    {
        using TestRun run = NewRun();
        ScriptedManager poster = run.Add("poster");
        MessagePublisher<Sample> publisher = poster.Publish<Sample>("sample");
        MessageSubscriber<Sample> early = run.Reactor.Workspace.Subscribe<Sample>("sample");
        early.OnPost(_ => run.Board.Write("ended before the start")).Dispose();
        IDisposable first = early.OnPost(_ => run.Board.Write("first"));
        early.OnPost(_ => run.Board.Write("second"));

        run.StartAndSettle();
        IDisposable late = run.Reactor.Workspace.Subscribe<Sample>("sample").OnPost(_ => run.Board.Write("late"));
        run.On(poster, publisher.Post);
        first.Dispose();
        first.Dispose();
        late.Dispose();
        run.On(poster, publisher.Post);

        Assert.Equal(["first", "second", "late", "second"], run.Board.Entries);
    }

    [Fact, Trait("Clause", "2.6")]
    public void Subscription_DisposedByItsHandler_IsCalledOnce()
    {
        using MessagePair pair = Connect();
        IDisposable? subscription = null;
        subscription = pair.Run.Reactor.Workspace.Subscribe<Sample>("sample").OnPost(_ =>
        {
            pair.Run.Board.Write("called");
            subscription!.Dispose();
        });

        for (int i = 0; i < 3; i++)
            pair.Run.On(pair.Poster, pair.Publisher.Post);

        Assert.Equal(["called"], pair.Run.Board.Entries);
    }

    [Fact, Trait("Clause", "2.6")]
    public void Subscriptions_ThatHaveEnded_AreNotKept()
    {
        using MessagePair pair = Connect();
        var kept = new List<WeakReference>();
        Subscribe(pair.Run.Reactor.Workspace, kept);

        GC.Collect();
        GC.WaitForPendingFinalizers();
        GC.Collect();

        Assert.True(kept.FindAll(k => k.IsAlive).Count <= 1);   // a conservative collector may see one on a stack
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Subscribe(RabitWorkspace workspace, List<WeakReference> kept)
    {
        for (int i = 0; i < 100; i++)
        {
            byte[] held = new byte[10];
            kept.Add(new WeakReference(held));
            workspace.Subscribe<Sample>("sample").OnPost(_ => held[0]++).Dispose();
        }
    }

    private MessagePair Connect() => new(NewRun());
}

public sealed class PostHandlerInRealTime() : PostHandlerContract(TimeKind.Real);

public sealed class PostHandlerInVirtualTime() : PostHandlerContract(TimeKind.Virtual);
