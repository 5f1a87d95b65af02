using System;
using System.Linq;
using System.Threading;
using Rabit.Core;

namespace Rabit.Benchmarks.Core.Queues;

/// <summary>As <see cref="FlatOut{T, TQueue}"/>, with managers: each moves its share in one long unit of work, and each push is to wake the receiver.</summary>
internal sealed class RabitFlatOut<T> : IContender
    where T : struct
{
    private readonly Sender[] _senders;
    private readonly Receiver _receiver;
    private readonly RabitReactor _reactor = new();

    public RabitFlatOut(string name, int senders, int capacity, QueueFullMode whenFull)
    {
        Name = name;
        _receiver = new Receiver(capacity, whenFull);
        _senders = [.. Enumerable.Range(1, senders).Select(i => new Sender("sender " + i))];
        _reactor.Add(_receiver);
        foreach (Sender sender in _senders)
            _reactor.Add(sender);
        _reactor.Start();
    }

    public string Name { get; }

    public void Transfer(int messages)
    {
        _receiver.Begin(messages);
        foreach (Sender sender in _senders)
            sender.Begin(messages / _senders.Length);
        _receiver.WaitForLast();
    }

    public void Dispose()
    {
        _reactor.Stop();
        _reactor.Finish();
        _receiver.Dispose();
    }

    private sealed class Sender : RabitManager
    {
        private readonly QueueSender<T> _queue;
        private int _toSend;   // set from outside before the wake, then the manager's

        public Sender(string name)
            : base(name)
        {
            _queue = Send<T>("queue");
            WakeUpDelay = TimeSpan.FromDays(1);
        }

        public void Begin(int messages)
        {
            Volatile.Write(ref _toSend, messages);
            WakeUp();
        }

        protected override void ExecuteUnitOfWork()
        {
            T value = default;
            var spin = default(SpinWait);
            for (; _toSend > 0; _toSend--)
            {
                while (_queue.Push(value) == PushResult.Rejected)
                    spin.SpinOnce(sleep1Threshold: -1);
            }
        }
    }

    private sealed class Receiver : RabitManager, IDisposable
    {
        private readonly QueueReceiver<T> _queue;
        private readonly ManualResetEventSlim _lastCame = new();
        private int _toReceive;   // set from outside before anything is sent, then the manager's

        public Receiver(int capacity, QueueFullMode whenFull)
            : base("receiver")
        {
            _queue = Receive<T>("queue", capacity, whenFull);
            WakeUpDelay = TimeSpan.FromDays(1);
        }

        public void Begin(int messages)
        {
            _lastCame.Reset();
            Volatile.Write(ref _toReceive, messages);
            WakeUp();
        }

        public void WaitForLast() => _lastCame.Wait();

        public void Dispose() => _lastCame.Dispose();

        protected override void ExecuteUnitOfWork()
        {
            if (_toReceive == 0)
                return;
            var spin = default(SpinWait);
            for (; _toReceive > 0; _toReceive--)
            {
                while (!_queue.TryPop(out _))
                    spin.SpinOnce(sleep1Threshold: -1);
            }

            _lastCame.Set();
        }
    }
}
