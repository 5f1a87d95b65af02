using System;
using System.Threading;
using Rabit.Core.Tests.Contracts;
using Xunit;

namespace Rabit.Core.Tests.Messages;

/// <summary>Contract 2.4: a fetched value is one that was posted, whole, and neither side starves the other.</summary>
[Trait("Category", "Stress")]
public sealed class TornValueTests
{
    private const int Posts = 300_000;

    [Fact, Trait("Clause", "2.4")]
    public void Value_PosterAndFetchersFlatOut_IsNeverTornAndBothSidesGoOn()
    {
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager poster = run.Add("poster");
        MessagePublisher<Block> publisher = poster.Publish<Block>("block", new Block(0));
        int done = 0;
        long[] news = new long[2];
        long[] posted = new long[2];
        var fetchers = new ScriptedManager[2];
        for (int f = 0; f < fetchers.Length; f++)
        {
            int number = f;
            fetchers[f] = run.Add("fetcher " + f);
            MessageSubscriber<Block> subscriber = fetchers[f].Subscribe<Block>("block");
            fetchers[f].OnUnit = () =>
            {
                long last = 0;
                while (last < Posts)
                {
                    if (!subscriber.FetchAndCountMissed(out int missed))
                        continue;
                    Assert.True(subscriber.Value.IsWhole, "torn");
                    Assert.Equal(last + missed + 1, subscriber.Value.Number);
                    last = subscriber.Value.Number;
                    news[number]++;
                    posted[number] += missed + 1;
                }

                Interlocked.Increment(ref done);
            };
        }

        poster.OnUnit = () =>
        {
            for (int i = 1; i <= Posts; i++)
            {
                publisher.Value = new Block(i);
                publisher.Post();
            }

            Interlocked.Increment(ref done);
        };

        run.Start();
        run.Until(() => Volatile.Read(ref done) == 3, "poster and fetchers come to the end");
        Assert.Equal(0, run.Finish().ExitCode);

        Assert.Equal([Posts, Posts], posted);
        Assert.All(news, n => Assert.True(n > 0));
    }

    [Fact, Trait("Clause", "2.4")]
    public void ReadStamp_PosterFlatOut_IsThatOfOnePost()
    {
        using var run = new TestRun(TimeKind.Real);
        ScriptedManager poster = run.Add("poster");
        MessagePublisher<int> publisher = poster.Publish<int>("number");
        int done = 0;
        poster.OnUnit = () =>
        {
            for (int i = 1; i <= Posts; i++)
                publisher.PostStamped(i, new TimeSpan(i));
            Interlocked.Increment(ref done);
        };

        run.Start();
        MessageObserver observer = Assert.Single(
            run.Reactor.Workspace.ObserveMessages(), m => m.ValueType == typeof(int));
        for (int last = 0; last < Posts;)
        {
            MessageStamp stamp = observer.ReadStamp();
            Assert.Equal(stamp.Version, stamp.Time.Ticks);
            Assert.True(stamp.Version >= last, "an older one");
            last = stamp.Version;
        }

        run.Until(() => Volatile.Read(ref done) == 1, "poster comes to the end");
        Assert.Equal(0, run.Finish().ExitCode);
    }

    /// <summary>72 bytes: longer than a cache line, so that no processor copies it in one piece.</summary>
    private readonly struct Block(long number)
    {
        private readonly long _a = number;
        private readonly long _b = number * 3;
        private readonly long _c = ~number;
        private readonly long _d = number ^ 0x5555;
        private readonly long _e = number + 7;
        private readonly long _f = -number;
        private readonly long _g = number << 8;
        private readonly long _h = number * number;
        private readonly long _checksum = unchecked((number * 3) + ~number + (number ^ 0x5555) + number + 7 - number
            + (number << 8) + (number * number));

        public long Number => _a;

        public bool IsWhole
            => _b == _a * 3 && unchecked(_b + _c + _d + _e + _f + _g + _h) == _checksum && _c == ~_a && _h == _a * _a;
    }
}
