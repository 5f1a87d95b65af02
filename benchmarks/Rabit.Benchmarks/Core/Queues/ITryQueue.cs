namespace Rabit.Benchmarks.Core.Queues;

/// <summary>A queue as a struct, so that the loops which drive it call it without a detour.</summary>
internal interface ITryQueue<T>
{
    bool TryPush(in T value);

    bool TryPop(out T value);
}
