using System;
using System.Threading.Channels;
using BenchmarkDotNet.Attributes;
using Rabit.Core;

namespace Rabit.Benchmarks.Core;

/// <summary>
/// A message of 72 bytes posted and fetched in a unit of work: real time, real clock, every check on the way.
/// </summary>
public abstract class MessageBenchmarks
{
    protected const int Operations = 200_000;

    private readonly MessageManager _manager = new();
    private readonly AwakeManager _awake = new();
    private readonly RabitReactor _reactor = new();

    private protected MessageManager Manager => _manager;

    private protected MonitorMessage<VehiclePose> Locked { get; } = new();

    private protected Channel<VehiclePose> LatestValue { get; } = Channels.LatestValue<VehiclePose>();

    /// <summary>
    /// Ends for code outside managers: they may be used on the thread of the benchmark, and on that of the manager.
    /// </summary>
    private protected MessagePublisher<VehiclePose> OutsidePose { get; private set; } = null!;

    private protected MessageSubscriber<VehiclePose> Pose { get; private set; } = null!;

    private protected MessageSubscriber<RouteNote> Plan { get; private set; } = null!;

    private protected MessageSubscriber<RangeScan> Scan { get; private set; } = null!;

    [GlobalSetup]
    public void Start()
    {
        OutsidePose = _reactor.Workspace.Publish<VehiclePose>("outside pose");
        _ = _reactor.Workspace.Publish<VehiclePose>("quiet pose");
        Pose = _reactor.Workspace.Subscribe<VehiclePose>("pose");
        Plan = _reactor.Workspace.Subscribe<RouteNote>("plan");
        Scan = _reactor.Workspace.Subscribe<RangeScan>("scan");
        _reactor.Add(_manager);
        _reactor.Add(_awake);
        _reactor.Start();
    }

    [GlobalCleanup]
    public void Stop()
    {
        _awake.LetGo();
        _reactor.Stop();
        _reactor.Finish();
        _manager.Dispose();
        _awake.Dispose();
    }

    /// <summary>
    /// Does something in a unit of work; so does what is compared with it, so that all pay the same for getting there.
    /// </summary>
    protected void InManager(Action work) => _manager.Do(work);
}
