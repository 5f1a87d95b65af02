using System;
using Rabit.Core;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;

namespace Rabit.Latency.Throughput;

/// <summary>
/// Transfers between managers, each within one unit of work: the queue alone is measured, not the wake-ups.
/// </summary>
internal sealed class RabitFlow<T> : IDisposable
    where T : struct
{
    private readonly RabitReactor _reactor = RabitRun.Create(WaitEngine.Best);
    private readonly FlatOutManager<Flow>[] _workers;

    public RabitFlow(int senders, int capacity)
    {
        bool pins = senders == 1;
        _workers = new FlatOutManager<Flow>[senders + 1];
        _workers[0] = new Receiver(capacity, pins ? Cpus.Other : null);
        for (int i = 1; i <= senders; i++)
            _workers[i] = new FlowSender<T>($"sender {i}", pins ? Cpus.One : null);
        foreach (FlatOutManager<Flow> worker in _workers)
            _reactor.Add(worker);
        _reactor.Start();
    }

    public double Run(int messages) => Run(new Flow(_workers.Length - 1, messages));

    /// <summary>Several values at a time.</summary>
    public double RunBatches(int messages) => Run(new Flow(_workers.Length - 1, messages, inBatches: true));

    public void Dispose()
    {
        RabitRun.End(_reactor);
        foreach (FlatOutManager<Flow> worker in _workers)
            worker.Dispose();
    }

    private double Run(Flow flow)
    {
        foreach (FlatOutManager<Flow> worker in _workers)
            worker.Begin(flow);
        foreach (FlatOutManager<Flow> worker in _workers)
            worker.WaitForEnd();
        return flow.MillionPerSecond;
    }

    private sealed class Receiver : FlatOutManager<Flow>
    {
        private readonly QueueReceiver<T> _queue;

        public Receiver(int capacity, int? cpu)
            : base("receiver", cpu) => _queue = Receive<T>("queue", capacity, wakeOnPush: false);

        protected override void Work(Flow flow)
        {
            var end = new PopEnd(_queue);
            if (flow.InBatches)
                flow.ReceiveBatches<PopEnd, T>(ref end);
            else
                flow.Receive<PopEnd, T>(ref end);
        }
    }

    private readonly struct PopEnd(QueueReceiver<T> queue) : IPop<T>, IPopBatch<T>
    {
        public bool TryPop(out T value) => queue.TryPop(out value);

        public int PopInto(Span<T> target) => queue.PopInto(target);
    }
}
