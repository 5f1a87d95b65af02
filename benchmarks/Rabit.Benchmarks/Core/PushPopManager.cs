using System;
using Rabit.Core;

namespace Rabit.Benchmarks.Core;

/// <summary>Pushes to and pops from its own queue, a given number of times in one unit of work.</summary>
internal sealed class PushPopManager<T> : RabitManager
    where T : struct
{
    private readonly QueueReceiver<T> _receiver;
    private readonly QueueSender<T> _sender;
    private readonly int _perRun;
    private readonly T _pushed;   // as in the other rows, what is popped is not pushed again
    private T _popped;

    public PushPopManager(int capacity, int perRun)
        : base("push-pop")
    {
        _receiver = Receive<T>("queue", capacity);
        _sender = Send<T>("queue");
        _perRun = perRun;
        _pushed = new T();
        WakeUpDelay = TimeSpan.FromDays(1);
    }

    public int Popped { get; set; }

    protected override void ExecuteUnitOfWork()
    {
        // Its own pushes wake it once more.
        if (WakeUpCauses != WakeUpCauses.Request)
            return;

        int popped = 0;
        for (int i = 0; i < _perRun; i++)
        {
            if (_sender.Push(_pushed) == PushResult.Queued && _receiver.TryPop(out _popped))
                popped++;
        }

        Popped = popped;
    }
}
