namespace Rabit.Core.Locks;

/// <summary>
/// What a lock with priority inheritance asks of the kernel where it is not free. A struct, so that the calls are
/// inlined; the tests have one that answers as they wish.
/// </summary>
internal unsafe interface IInheritanceCalls
{
    /// <inheritdoc cref="InheritanceFutex.Lock"/>
    int Lock(int* word);

    /// <inheritdoc cref="InheritanceFutex.IsAlive"/>
    bool IsAlive(int threadId);
}
