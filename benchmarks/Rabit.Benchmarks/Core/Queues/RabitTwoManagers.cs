using System;
using Rabit.Core;

namespace Rabit.Benchmarks.Core.Queues;

/// <summary>One manager pushes all, another pops all, in turn on one thread (virtual time): as between threads, with nothing in the way.</summary>
internal sealed class RabitTwoManagers<T> : IContender
    where T : struct
{
    private readonly Sender _sender = new();
    private readonly Receiver _receiver;
    private readonly RabitReactor _reactor;

    public RabitTwoManagers(string name, int capacity)
    {
        Name = name;
        _receiver = new Receiver(capacity);
        _reactor = new RabitReactor(new VirtualTime()) { _sender, _receiver };
        _reactor.Start();
        _reactor.RunFor(TimeSpan.FromMilliseconds(1));
    }

    public string Name { get; }

    public void Transfer(int messages)
    {
        _receiver.Popped = 0;
        _sender.Send(messages);
        _reactor.RunFor(TimeSpan.FromMilliseconds(1));
        if (_receiver.Popped != messages)
            throw new InvalidOperationException(Name + " lost something.");
    }

    public void Dispose()
    {
        _reactor.Stop();
        _reactor.Finish();
    }

    private sealed class Sender : RabitManager
    {
        private readonly QueueSender<T> _queue;
        private int _toSend;

        public Sender()
            : base("sender")
        {
            _queue = Send<T>("queue");
            WakeUpDelay = TimeSpan.FromDays(1);
        }

        public void Send(int messages)
        {
            _toSend = messages;
            WakeUp();
        }

        protected override void ExecuteUnitOfWork()
        {
            T value = default;
            for (; _toSend > 0; _toSend--)
                _queue.Push(value);
        }
    }

    private sealed class Receiver : RabitManager
    {
        private readonly QueueReceiver<T> _queue;

        public Receiver(int capacity)
            : base("receiver")
        {
            _queue = Receive<T>("queue", capacity);
            WakeUpDelay = TimeSpan.FromDays(1);
        }

        public int Popped { get; set; }

        protected override void ExecuteUnitOfWork()
        {
            int popped = 0;
            while (_queue.TryPop(out _))
                popped++;
            Popped += popped;
        }
    }
}
