namespace Rabit.Core.Locks;

/// <summary>The calls of the kernel.</summary>
internal readonly unsafe struct InheritanceCalls : IInheritanceCalls
{
    public int Lock(int* word) => InheritanceFutex.Lock(word);

    public bool IsAlive(int threadId) => InheritanceFutex.IsAlive(threadId);
}
