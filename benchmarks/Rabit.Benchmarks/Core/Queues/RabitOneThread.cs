using System;
using Rabit.Core;

namespace Rabit.Benchmarks.Core.Queues;

/// <summary>A manager that pushes to itself and pops, in its unit of work; each push is to wake it.</summary>
internal sealed class RabitOneThread<T> : IContender
    where T : struct
{
    private readonly PushPop _manager;
    private readonly VirtualSteps _turns;

    public RabitOneThread(string name, int capacity, QueueFullMode whenFull)
    {
        Name = name;
        _manager = new PushPop(capacity, whenFull);
        _turns = new VirtualSteps(_manager);
    }

    public string Name { get; }

    public void Transfer(int messages)
    {
        _manager.Messages = messages;
        _manager.Popped = 0;
        _turns.Give();
        if (_manager.Popped != messages)
            throw new InvalidOperationException(Name + " lost something.");
    }

    public void Dispose() => _turns.Dispose();

    private sealed class PushPop : RabitManager
    {
        private readonly QueueReceiver<T> _receiver;
        private readonly QueueSender<T> _sender;

        public PushPop(int capacity, QueueFullMode whenFull)
            : base("push-pop")
        {
            _receiver = Receive<T>("queue", capacity, whenFull);
            _sender = Send<T>("queue");
            WakeUpDelay = TimeSpan.FromDays(1);
        }

        public int Messages { get; set; }

        public int Popped { get; set; }

        protected override void ExecuteUnitOfWork()
        {
            // Its own pushes wake it once more.
            if (WakeUpCauses != WakeUpCauses.Request)
                return;
            int popped = 0;
            T value = default;
            for (int i = Messages; i > 0; i--)
            {
                if (_sender.Push(value) == PushResult.Queued && _receiver.TryPop(out value))
                    popped++;
            }

            Popped = popped;
        }
    }
}
