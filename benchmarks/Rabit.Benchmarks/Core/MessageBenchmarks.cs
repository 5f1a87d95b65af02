using System.Threading.Channels;
using BenchmarkDotNet.Attributes;
using Rabit.Core;

namespace Rabit.Benchmarks.Core;

/// <summary>A message of 72 bytes with ends outside managers: real time, real clock, every check on the way.</summary>
public abstract class MessageBenchmarks
{
    private readonly RabitReactor _reactor = new() { new IdleManager() };

    private protected LockedMessage<VehiclePose> Locked { get; } = new();

    private protected Channel<VehiclePose> LatestValue { get; } = Channels.LatestValue<VehiclePose>();

    private protected MessagePublisher<VehiclePose> Publisher { get; private set; } = null!;

    private protected MessageSubscriber<VehiclePose> Subscriber { get; private set; } = null!;

    [GlobalSetup]
    public void Start()
    {
        Publisher = _reactor.Workspace.Publish<VehiclePose>("pose");
        Subscriber = _reactor.Workspace.Subscribe<VehiclePose>("pose");
        _reactor.Start();
    }

    [GlobalCleanup]
    public void Stop()
    {
        _reactor.Stop();
        _reactor.Finish();
    }
}
