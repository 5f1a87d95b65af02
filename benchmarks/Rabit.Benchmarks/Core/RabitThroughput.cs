using System;
using System.Linq;
using System.Threading;
using Rabit.Core;

namespace Rabit.Benchmarks.Core;

/// <summary>Managers: a sender returns when the queue is full and is woken by a pop; the receiver pops all there is and is woken by a push.</summary>
internal sealed class RabitThroughput : ThroughputRun
{
    private readonly Sender[] _senders;
    private readonly Receiver _receiver;
    private readonly RabitReactor _reactor = new();

    public RabitThroughput(int senders, int capacity)
    {
        _receiver = new Receiver(capacity);
        _senders = [.. Enumerable.Range(1, senders).Select(i => new Sender("sender " + i))];
        _reactor.Add(_receiver);
        foreach (Sender sender in _senders)
            _reactor.Add(sender);
        _reactor.Start();
    }

    public override void Transfer(int messages)
    {
        _receiver.Expect(messages);
        foreach (Sender sender in _senders)
            sender.Begin(messages / _senders.Length);
        _receiver.WaitForLast();
    }

    public override void Dispose()
    {
        _reactor.Stop();
        _reactor.Finish();
        _receiver.Dispose();
    }

    private sealed class Sender : RabitManager
    {
        private readonly QueueSender<Block64> _queue;
        private int _toSend;   // set from outside before the wake, then counted down by the manager

        public Sender(string name)
            : base(name)
        {
            _queue = Send<Block64>("queue", wakeOnPop: true);
            WakeUpDelay = TimeSpan.FromDays(1);
        }

        public void Begin(int messages)
        {
            Volatile.Write(ref _toSend, messages);
            WakeUp();
        }

        protected override void ExecuteUnitOfWork()
        {
            Block64 message = default;
            while (_toSend > 0)
            {
                message.Number = _toSend;
                if (_queue.Push(message) == PushResult.Rejected)
                    return;
                _toSend--;
            }
        }
    }

    private sealed class Receiver : RabitManager, IDisposable
    {
        private readonly QueueReceiver<Block64> _queue;
        private readonly ManualResetEventSlim _lastCame = new();
        private int _toReceive;   // set from outside before anything is sent, then counted down by the manager

        public Receiver(int capacity)
            : base("receiver")
        {
            _queue = Receive<Block64>("queue", capacity);
            WakeUpDelay = TimeSpan.FromDays(1);
        }

        public void Expect(int messages)
        {
            _lastCame.Reset();
            Volatile.Write(ref _toReceive, messages);
        }

        public void WaitForLast() => _lastCame.Wait();

        public void Dispose() => _lastCame.Dispose();

        protected override void ExecuteUnitOfWork()
        {
            while (_queue.TryPop(out _))
            {
                if (--_toReceive == 0)
                    _lastCame.Set();
            }
        }
    }
}
