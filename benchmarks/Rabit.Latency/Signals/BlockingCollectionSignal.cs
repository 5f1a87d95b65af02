using System.Collections.Concurrent;

namespace Rabit.Latency.Signals;

/// <summary>A bounded <see cref="BlockingCollection{T}"/>.</summary>
internal sealed class BlockingCollectionSignal : Signal
{
    private readonly BlockingCollection<int> _items = new(16);

    public override void Set() => _items.TryAdd(1);

    public override void Wait() => _items.Take();

    public override void Dispose() => _items.Dispose();
}
