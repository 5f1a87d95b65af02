using System;

namespace Rabit.Benchmarks.Core.Queues;

/// <summary>A push, and the pop that takes it out, on the calling thread.</summary>
internal sealed class OneThread<T, TQueue>(string name, TQueue queue) : IContender
    where TQueue : struct, ITryQueue<T>
    where T : struct
{
    private readonly TQueue _queue = queue;

    public string Name => name;

    public void Transfer(int messages)
    {
        int popped = 0;
        T value = default;
        for (int i = 0; i < messages; i++)
        {
            if (_queue.TryPush(value) && _queue.TryPop(out value))
                popped++;
        }

        if (popped != messages)
            throw new InvalidOperationException(name + " lost something.");
    }

    public void Dispose()
    {
    }
}
