using System;
using System.Threading;
using Rabit.Core;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;

namespace Rabit.Latency.Throughput;

/// <summary>
/// Transfers from managers that push within one unit of work to one that is woken by the pushes, takes out all there is
/// and sleeps again.
/// </summary>
internal sealed class RabitWakingFlow<T> : IDisposable
    where T : struct
{
    private readonly RabitReactor _reactor = RabitRun.Create(WaitEngine.Best);
    private readonly Receiver _receiver;
    private readonly FlowSender<T>[] _senders;

    public RabitWakingFlow(int senders, int capacity)
    {
        bool pins = senders == 1;
        _receiver = new Receiver(capacity, pins ? Cpus.Other : null);
        _reactor.Add(_receiver);
        _senders = new FlowSender<T>[senders];
        for (int i = 0; i < senders; i++)
        {
            _senders[i] = new FlowSender<T>($"sender {i + 1}", pins ? Cpus.One : null);
            _reactor.Add(_senders[i]);
        }

        _reactor.Start();
    }

    public double Run(int messages)
    {
        var flow = new Flow(_senders.Length, messages, startsReceiver: false);
        _receiver.Begin(flow);
        foreach (FlowSender<T> sender in _senders)
            sender.Begin(flow);
        foreach (FlowSender<T> sender in _senders)
            sender.WaitForEnd();
        _receiver.WaitForEnd();
        return flow.MillionPerSecond;
    }

    public void Dispose()
    {
        RabitRun.End(_reactor);
        _receiver.Dispose();
        foreach (FlowSender<T> sender in _senders)
            sender.Dispose();
    }

    private sealed class Receiver : RabitManager, IDisposable
    {
        private readonly AutoResetEvent _ended = new(initialState: false);
        private readonly Sink<T> _sink = new();
        private readonly QueueReceiver<T> _queue;
        private readonly int? _cpu;
        private Flow? _flow;      // set from outside before the senders begin
        private int _received;

        public Receiver(int capacity, int? cpu)
            : base("receiver")
        {
            _queue = Receive<T>("queue", capacity);
            _cpu = cpu;
            WakeUpDelay = Timeout.InfiniteTimeSpan;
        }

        public void Begin(Flow flow) => Volatile.Write(ref _flow, flow);

        public void WaitForEnd() => _ended.WaitOne();

        public void Dispose() => _ended.Dispose();

        protected override void Startup()
        {
            if (_cpu is { } cpu)
                Cpus.Pin(cpu);
        }

        protected override void ExecuteUnitOfWork()
        {
            int received = _received;
            while (_queue.TryPop(out T value))
            {
                _sink.Take(value);
                received++;
            }

            _received = received;
            if (Volatile.Read(ref _flow) is not { } flow || received < flow.Messages)
                return;
            flow.End();
            _received = 0;
            Volatile.Write(ref _flow, null);
            _ended.Set();
        }
    }
}
