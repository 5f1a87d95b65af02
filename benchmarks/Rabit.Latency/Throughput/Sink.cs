using System.Runtime.CompilerServices;

namespace Rabit.Latency.Throughput;

/// <summary>
/// Takes what was received, so that it must really be received: where a value goes nowhere, the compiler leaves the
/// copy out of those queues that it can inline, and their senders and receivers never touch the same cache line.
/// </summary>
internal sealed class Sink<T>
{
    private T _last = default!;

    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Take(in T value) => _last = value;
}
