using System;
using System.Threading;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;

namespace Rabit.Latency.Contention;

/// <summary>A poster and a fetcher, flat out, on two CPUs, for a time.</summary>
internal sealed class ContentionRun
{
    private volatile bool _stopped;
    private long _posts;   // written by the poster at its end
    private long _news;    // written by the fetcher at its end

    public bool IsStopped => _stopped;

    /// <summary>Reported by the poster and the fetcher at their ends.</summary>
    public void Report(long? posts = null, long? news = null)
    {
        if (posts is { } p)
            Interlocked.Exchange(ref _posts, p);
        if (news is { } n)
            Interlocked.Exchange(ref _news, n);
    }

    /// <returns>Posts and news in millions per second.</returns>
    public double[] Run(double seconds, Action begin, Action waitForEnd)
    {
        begin();
        long start = MonotonicClock.Now;
        MonotonicClock.SleepMilliseconds(seconds * 1e3);
        double took = (MonotonicClock.Now - start) / 1e3;
        _stopped = true;
        waitForEnd();
        return [Interlocked.Read(ref _posts) / took, Interlocked.Read(ref _news) / took];
    }

    /// <summary>With two threads without Rabit.</summary>
    /// <param name="seconds">How long.</param>
    /// <param name="post">Posts once.</param>
    /// <param name="fetch">Fetches once, and says whether it was news.</param>
    public static double[] OnThreads(double seconds, Action post, Func<bool> fetch)
    {
        var contention = new ContentionRun();
        Thread? poster = null;
        Thread? fetcher = null;
        return contention.Run(
            seconds,
            () =>
            {
                poster = Pinned.Start(Cpus.One, "poster", () => contention.Post(post));
                fetcher = Pinned.Start(Cpus.Other, "fetcher", () => contention.Fetch(fetch));
            },
            () =>
            {
                poster!.Join();
                fetcher!.Join();
            });
    }

    public void Post(Action post)
    {
        long posts = 0;
        for (; !_stopped; posts++)
            post();
        Report(posts: posts);
    }

    public void Fetch(Func<bool> fetch)
    {
        long news = 0;
        while (!_stopped)
        {
            if (fetch())
                news++;
        }

        Report(news: news);
    }
}
