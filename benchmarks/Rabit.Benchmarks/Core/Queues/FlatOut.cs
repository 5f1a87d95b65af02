using System.Threading;

namespace Rabit.Benchmarks.Core.Queues;

/// <summary>Senders and a receiver on threads of their own that never sleep: who finds the queue full or empty spins, and soon yields.</summary>
internal sealed class FlatOut<T, TQueue>(string name, int senders, TQueue queue) : ThreadedThroughput(senders), IContender
    where TQueue : struct, ITryQueue<T>
    where T : struct
{
    private readonly TQueue _queue = queue;

    public string Name => name;

    protected override void Send(int count)
    {
        T value = default;
        var spin = default(SpinWait);
        for (int i = 0; i < count; i++)
        {
            while (!_queue.TryPush(value))
                spin.SpinOnce(sleep1Threshold: -1);
        }
    }

    protected override void Receive(int count)
    {
        var spin = default(SpinWait);
        for (int i = 0; i < count; i++)
        {
            while (!_queue.TryPop(out _))
                spin.SpinOnce(sleep1Threshold: -1);
        }
    }
}
