using System;
using System.Globalization;
using System.Linq;
using Rabit.Core;
using Rabit.Latency.Contention;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;

namespace Rabit.Latency.Cost;

/// <summary>Many messages from one manager to another, which run from the making to the end.</summary>
internal sealed class ManyMessages : IDisposable
{
    private const int Posts = 1_000_000;

    private readonly RabitReactor _reactor = RabitRun.Create(WaitEngine.Best);
    private readonly Poster _poster;

    public ManyMessages(int number)
    {
        _poster = new Poster(number);
        _reactor.Add(_poster);
        _reactor.Add(new Subscriber(number));
        _reactor.Start();
    }

    /// <summary>Posts to all in turn, again and again; nothing is fetched meanwhile.</summary>
    /// <returns>Nanoseconds a post takes, on the average.</returns>
    public double PostAll()
    {
        Post(Posts / 10);   // until it is compiled, and the memory touched
        return Post(Posts);
    }

    public void Dispose()
    {
        RabitRun.End(_reactor);
        _poster.Dispose();
    }

    private double Post(int posts)
    {
        var job = new PostJob(posts);
        _poster.Begin(job);
        _poster.WaitForEnd();
        return (double)job.Nanoseconds / posts;
    }

    private static string NameOf(int message) => message.ToString(CultureInfo.InvariantCulture);

    private sealed class PostJob(int posts)
    {
        public int Posts => posts;

        /// <summary>Written by the manager, read when it has ended the job.</summary>
        public long Nanoseconds { get; set; }
    }

    private sealed class Poster : FlatOutManager<PostJob>
    {
        private readonly MessagePublisher<TestPose>[] _publishers;

        public Poster(int number)
            : base("poster", cpu: null)
            => _publishers = [.. Enumerable.Range(0, number).Select(i => Publish<TestPose>(NameOf(i)))];

        protected override void Work(PostJob job)
        {
            TestPose pose = default;
            long start = MonotonicClock.Now;
            int next = 0;
            for (int i = 0; i < job.Posts; i++)
            {
                _publishers[next].Post(pose);
                next = next + 1 == _publishers.Length ? 0 : next + 1;
            }

            job.Nanoseconds = MonotonicClock.Now - start;
        }
    }

    private sealed class Subscriber : RabitManager
    {
        public Subscriber(int number)
            : base("subscriber")
        {
            WakeUpDelay = TimeSpan.FromHours(1);
            for (int i = 0; i < number; i++)
                Subscribe<TestPose>(NameOf(i));
        }

        protected override void ExecuteUnitOfWork()
        {
        }
    }
}
