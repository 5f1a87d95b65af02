using System;
using Rabit.Core;
using Rabit.Latency.Contention;

namespace Rabit.Latency.Inversion;

/// <summary>A manager of a real-time priority that uses one endpoint.</summary>
internal abstract class CallingManager : RabitManager
{
    private const string MessageName = "pose";

    protected CallingManager(string name, int priority, int cpu, EndpointCall call)
        : base(name)
    {
        RequestRealTime(new RealTimeRequest { Priority = priority, Cpus = [cpu] });
        Call = Declare(call);
    }

    /// <summary>Uses the endpoint once.</summary>
    protected Action Call { get; }

    private Action Declare(EndpointCall call)
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
            case EndpointCall.PushDropping:
                QueueSender<TestPose> poses = Send<TestPose>(ComputingManager.QueueName);
                return () => _ = poses.Push(default);   // the oldest makes room
            default:
                throw new ArgumentOutOfRangeException(nameof(call), call, "There is no such call.");
        }
    }
}
