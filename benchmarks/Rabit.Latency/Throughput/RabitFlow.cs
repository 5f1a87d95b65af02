using System;
using System.Threading;
using Rabit.Core;
using Rabit.Latency.Native;

namespace Rabit.Latency.Throughput;

/// <summary>Transfers between managers, each within one unit of work: the queue alone is measured, not the wake-ups.</summary>
internal sealed class RabitFlow<T> : IDisposable
    where T : struct
{
    private readonly RabitReactor _reactor = RabitRun.Create(WaitEngine.Best);
    private readonly Worker[] _workers;

    public RabitFlow(int senders, int capacity)
    {
        bool pins = senders == 1;
        _workers = new Worker[senders + 1];
        _workers[0] = new Receiver(capacity, pins ? Cpus.Other : null);
        for (int i = 1; i <= senders; i++)
            _workers[i] = new Sender($"sender {i}", pins ? Cpus.One : null);
        foreach (Worker worker in _workers)
            _reactor.Add(worker);
        _reactor.Start();
    }

    public double Run(int messages)
    {
        var flow = new Flow(_workers.Length - 1, messages);
        foreach (Worker worker in _workers)
            worker.Begin(flow);
        foreach (Worker worker in _workers)
            worker.WaitForEnd();
        return flow.MillionPerSecond;
    }

    public void Dispose()
    {
        RabitRun.End(_reactor);
        foreach (Worker worker in _workers)
            worker.Dispose();
    }

    private abstract class Worker : RabitManager, IDisposable
    {
        private readonly AutoResetEvent _ended = new(initialState: false);
        private readonly int? _cpu;
        private Flow? _flow;   // set from outside before the wake; taken by the manager

        protected Worker(string name, int? cpu)
            : base(name)
        {
            _cpu = cpu;
            WakeUpDelay = TimeSpan.FromHours(1);
        }

        public void Begin(Flow flow)
        {
            Volatile.Write(ref _flow, flow);
            WakeUp();
        }

        public void WaitForEnd() => _ended.WaitOne();

        public void Dispose() => _ended.Dispose();

        protected override void Startup()
        {
            if (_cpu is { } cpu)
                Cpus.Pin(cpu);
        }

        protected override void ExecuteUnitOfWork()
        {
            if (Interlocked.Exchange(ref _flow, null) is not { } flow)
                return;
            Work(flow);
            _ended.Set();
        }

        protected abstract void Work(Flow flow);
    }

    private sealed class Sender : Worker
    {
        private readonly QueueSender<T> _queue;

        public Sender(string name, int? cpu)
            : base(name, cpu) => _queue = Send<T>("queue");

        protected override void Work(Flow flow)
        {
            var end = new PushEnd(_queue);
            flow.Send<PushEnd, T>(ref end, default);
        }
    }

    private sealed class Receiver : Worker
    {
        private readonly QueueReceiver<T> _queue;

        public Receiver(int capacity, int? cpu)
            : base("receiver", cpu) => _queue = Receive<T>("queue", capacity, wakeOnPush: false);

        protected override void Work(Flow flow)
        {
            var end = new PopEnd(_queue);
            flow.Receive<PopEnd, T>(ref end);
        }
    }

    private readonly struct PushEnd(QueueSender<T> queue) : IPush<T>
    {
        public bool TryPush(in T value) => queue.Push(value) != PushResult.Rejected;
    }

    private readonly struct PopEnd(QueueReceiver<T> queue) : IPop<T>
    {
        public bool TryPop(out T value) => queue.TryPop(out value);
    }
}
