namespace Rabit.Benchmarks.Core.Queues;

/// <summary>The limit, as a struct.</summary>
internal readonly struct SpscPeer<T>(int capacity) : ITryQueue<T>
{
    private readonly SpscRing<T> _ring = new(capacity);

    public bool TryPush(in T value) => _ring.TryPush(value);

    public bool TryPop(out T value) => _ring.TryPop(out value);
}
