using System;
using Rabit.Core;
using Rabit.Latency.Contention;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Latency.Throughput;

namespace Rabit.Latency.Calls;

/// <summary>
/// A manager that posts, fetches, pushes and pops in loops; what it posts is fetched outside, on its own thread.
/// </summary>
internal sealed class CallManager : FlatOutManager<CallJob>
{
    private readonly MessagePublisher<TestPose> _publisher;
    private readonly MessageSubscriber<TestPose> _subscriber;
    private readonly QueueSender<Block64> _sender;
    private readonly QueueReceiver<Block64> _receiver;
    private readonly Sink<TestPose> _poses = new();
    private readonly Sink<Block64> _blocks = new();
    private readonly MessageSubscriber<TestPose> _outside;
    private Action<int> _work = _ => { };   // set from outside before the job is given
    private long _time;

    public CallManager(RabitWorkspace workspace)
        : base("caller", Cpus.One)
    {
        _publisher = Publish<TestPose>("pose");
        _subscriber = Subscribe<TestPose>("pose");
        _outside = workspace.Subscribe<TestPose>("pose");
        _sender = Send<Block64>("blocks");
        _receiver = Receive<Block64>("blocks", capacity: 1024, wakeOnPush: false);
    }

    public double[] FetchUnchanged(int calls) => Run(calls, Fetch);

    public double[] PostAndFetch(int calls) => Run(calls, Post);

    public double[] PushAndPop(int calls) => Run(calls, Push);

    protected override void Work(CallJob job) => job.Measure(() => _work(job.Calls));

    private double[] Run(int calls, Action<int> work)
    {
        var job = new CallJob(calls);
        _work = work;
        Begin(job);
        WaitForEnd();
        return job.Cost;
    }

    private void Fetch(int calls)
    {
        for (int i = 0; i < calls; i++)
        {
            if (_subscriber.Fetch())
                throw new InvalidOperationException("One's own post is no news.");
        }
    }

    private void Post(int calls)
    {
        for (int i = 0; i < calls; i++)
        {
            _publisher.Value.TimeSeconds++;
            _publisher.PostStamped(new TimeSpan(++_time));
            if (!_outside.Fetch())
                throw new InvalidOperationException("A post was not seen.");
            _poses.Take(_outside.Value);
        }
    }

    private void Push(int calls)
    {
        for (int i = 0; i < calls; i++)
        {
            _ = _sender.Push(new Block64 { Number = i });
            if (!_receiver.TryPop(out Block64 block))
                throw new InvalidOperationException("A value was lost.");
            _blocks.Take(block);
        }
    }
}
