using System;
using Rabit.Core;
using Rabit.Latency.Measuring;

namespace Rabit.Latency.Throughput;

/// <summary>A manager that pushes all values of a flow within one unit of work.</summary>
internal sealed class FlowSender<T> : FlatOutManager<Flow>
    where T : struct
{
    private readonly QueueSender<T> _queue;

    public FlowSender(string name, int? cpu)
        : base(name, cpu) => _queue = Send<T>("queue");

    protected override void Work(Flow flow)
    {
        var end = new PushEnd(_queue);
        if (flow.InBatches)
            flow.SendBatches<PushEnd, T>(ref end);
        else
            flow.Send<PushEnd, T>(ref end, default);
    }

    private readonly struct PushEnd(QueueSender<T> queue) : IPush<T>, IPushBatch<T>
    {
        public bool TryPush(in T value) => queue.Push(value) != PushResult.Rejected;

        public int PushFrom(ReadOnlySpan<T> values) => queue.PushFrom(values);
    }
}
