using System;
using Rabit.Core;
using Rabit.Latency.Contention;

namespace Rabit.Latency.Inversion;

/// <summary>A manager of a real-time priority that uses one endpoint.</summary>
internal abstract class CallingManager : RabitManager
{
    private const string MessageName = "pose";

    protected CallingManager(string name, int priority, int cpu, EndpointCall call, RabitWorkspace workspace)
        : base(name)
    {
        RequestRealTime(new RealTimeRequest { Priority = priority, Cpus = [cpu] });
        Call = Declare(call, workspace);
    }

    /// <summary>Uses the endpoint once.</summary>
    protected Action Call { get; }

    private Action Declare(EndpointCall call, RabitWorkspace workspace)
    {
        switch (call)
        {
            case EndpointCall.PostShared:
                return Publish<TestPose>(MessageName, default, allowOtherPublishers: true).Post;
            case EndpointCall.PostAlone:
                return Publish<TestPose>(MessageName).Post;
            case EndpointCall.Fetch:
                MessageSubscriber<TestPose> pose = Subscribe<TestPose>(MessageName);
                return () => pose.ForceFetch();
            case EndpointCall.PostCopying:
                return Publish(MessageName, new CopyingTable(), allowOtherPublishers: true).Post;
            case EndpointCall.PushDroppingOldest or EndpointCall.PushDroppingNewest or EndpointCall.PushRejecting:
                QueueSender<TestPose> poses = Send<TestPose>(ComputingManager.QueueName);
                return () => _ = poses.Push(default);   // what does not fit in is dropped or rejected
            case EndpointCall.PopOutside:
                // On this manager's thread: any thread may use it, and this one has the priority.
                QueueReceiver<TestPose> outside = workspace.Receive<TestPose>(
                    ComputingManager.QueueName, ComputingManager.QueueCapacity);
                return () => _ = outside.TryPop(out _);
            default:
                throw new ArgumentOutOfRangeException(nameof(call), call, "There is no such call.");
        }
    }
}
