using System;
using System.Collections.Concurrent;
using System.Runtime.CompilerServices;
using System.Threading;
using Rabit.Latency.Contention;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Latency.Throughput;

namespace Rabit.Latency.Calls;

/// <summary>The same calls without Rabit.</summary>
internal sealed class BaselineCalls
{
    private readonly LockedMessage<TestPose> _message = new(default);
    private readonly MpscRing<Block64> _ring = new(1024);
    private readonly ConcurrentQueue<Block64> _queue = new();
    private readonly Sink<TestPose> _poses = new();
    private readonly Sink<Block64> _blocks = new();
    private int _version;

    public double[] FetchUnchanged(int calls) => Run(calls, () =>
    {
        int seen = _version;
        for (int i = 0; i < calls; i++)
        {
            if (IsNews(seen))
                throw new InvalidOperationException("Nothing was posted.");
        }
    });

    public double[] PostAndFetch(int calls) => Run(calls, () =>
    {
        TestPose posted = default;
        for (int i = 0; i < calls; i++)
        {
            posted.TimeSeconds++;
            _message.Post(posted);
            _version++;
            if (!_message.Fetch(out TestPose fetched))
                throw new InvalidOperationException("A post was not seen.");
            _poses.Take(fetched);
        }
    });

    public double[] PushAndPopRing(int calls) => Run(calls, () =>
    {
        for (int i = 0; i < calls; i++)
        {
            _ring.TryPush(new Block64 { Number = i });
            _ring.TryPop(out Block64 block);
            _blocks.Take(block);
        }
    });

    public double[] PushAndPopConcurrentQueue(int calls) => Run(calls, () =>
    {
        for (int i = 0; i < calls; i++)
        {
            _queue.Enqueue(new Block64 { Number = i });
            _queue.TryDequeue(out Block64 block);
            _blocks.Take(block);
        }
    });

    private static double[] Run(int calls, Action work)
    {
        var job = new CallJob(calls);
        Pinned.Run(Cpus.One, () => job.Measure(work));
        return job.Cost;
    }

    // A call: what a library has to be reached by.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool IsNews(int seen) => Volatile.Read(ref _version) != seen;
}
