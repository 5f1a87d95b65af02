using System.Collections.Concurrent;
using System.Threading.Channels;

namespace Rabit.Benchmarks.Core.Queues;

#pragma warning disable MA0048 // four wrappers of a few lines each

internal readonly struct ChannelPeer<T>(int capacity, int senders, BoundedChannelFullMode whenFull = BoundedChannelFullMode.Wait) : ITryQueue<T>
{
    private readonly Channel<T> _channel = Channel.CreateBounded<T>(
        new BoundedChannelOptions(capacity) { SingleReader = true, SingleWriter = senders == 1, FullMode = whenFull });

    public bool TryPush(in T value) => _channel.Writer.TryWrite(value);

    public bool TryPop(out T value) => _channel.Reader.TryRead(out value!);
}

/// <summary>Not bounded: it never has to look whether it is full.</summary>
internal readonly struct ConcurrentQueuePeer<T>() : ITryQueue<T>
{
    private readonly ConcurrentQueue<T> _queue = new();

    public bool TryPush(in T value)
    {
        _queue.Enqueue(value);
        return true;
    }

    public bool TryPop(out T value) => _queue.TryDequeue(out value!);
}

internal readonly struct BlockingCollectionPeer<T>(int capacity) : ITryQueue<T>
{
    private readonly BlockingCollection<T> _queue = new(capacity);

    public bool TryPush(in T value) => _queue.TryAdd(value);

    public bool TryPop(out T value) => _queue.TryTake(out value!);
}

internal readonly struct LockPeer<T>(int capacity) : ITryQueue<T>
{
    private readonly LockedQueue<T> _queue = new(capacity);

    public bool TryPush(in T value) => _queue.TryPush(value);

    public bool TryPop(out T value) => _queue.TryPop(out value!);
}
