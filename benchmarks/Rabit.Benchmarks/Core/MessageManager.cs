using System;
using System.Threading;
using Rabit.Core;

namespace Rabit.Benchmarks.Core;

/// <summary>
/// Executes on its own thread the operations it is given, since that is where messages are posted and fetched. Handing
/// over costs some microseconds; it is given a hundred thousand at a time.
/// </summary>
internal sealed class MessageManager : RabitManager, IDisposable
{
    private readonly ManualResetEventSlim _done = new();
    private Action? _work;   // set from outside before the wake, then read by the manager

    public MessageManager()
        : base("bench")
    {
        Pose = Publish<VehiclePose>("pose");
        WakingPose = Publish<VehiclePose>("waking pose");
        Plan = Publish("plan", Plans[0]);
        Scan = Publish("scan", new RangeScan());
        Quiet = Subscribe<VehiclePose>("quiet pose");
        WakeUpDelay = TimeSpan.FromDays(1);
    }

    public static RouteNote[] Plans { get; } = [new(1), new(2)];

    public MessagePublisher<VehiclePose> Pose { get; }

    /// <summary>Wakes a manager that is awake.</summary>
    public MessagePublisher<VehiclePose> WakingPose { get; }

    public MessagePublisher<RouteNote> Plan { get; }

    public MessagePublisher<RangeScan> Scan { get; }

    /// <summary>A message that no manager posts while it is measured.</summary>
    public MessageSubscriber<VehiclePose> Quiet { get; }

    public void Do(Action work)
    {
        _done.Reset();
        Volatile.Write(ref _work, work);
        WakeUp();
        _done.Wait();
    }

    public void Dispose() => _done.Dispose();

    protected override void ExecuteUnitOfWork()
    {
        if (Interlocked.Exchange(ref _work, null) is not { } work)
            return;
        work();
        _done.Set();
    }
}
