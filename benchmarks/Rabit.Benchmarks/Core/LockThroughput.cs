namespace Rabit.Benchmarks.Core;

/// <summary>By hand: a ring, a lock, and Monitor.Wait.</summary>
internal sealed class LockThroughput(int senders, int capacity) : ThreadedThroughput(senders)
{
    private readonly LockedQueue<Block64> _queue = new(capacity);

    protected override void Send(int count)
    {
        Block64 message = default;
        for (int i = 0; i < count; i++)
        {
            message.Number = i;
            _queue.Push(message);
        }
    }

    protected override void Receive(int count)
    {
        for (int i = 0; i < count; i++)
            _queue.Pop();
    }
}
