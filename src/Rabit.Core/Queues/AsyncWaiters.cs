using System.Collections.Generic;
using System.Threading.Tasks;

namespace Rabit.Core.Queues;

/// <summary>Async code that waits for the same thing: for room in a queue, or for something to pop.</summary>
internal sealed class AsyncWaiters
{
    // under the lock of the queue, until it lets go of the object
    private readonly List<TaskCompletionSource<bool>> _waiters = [];

    /// <summary>Under the lock of the queue.</summary>
    public TaskCompletionSource<bool> Add()
    {
        // Who waits in vain, and is cancelled again and again, must not fill the memory.
        _waiters.RemoveAll(w => w.Task.IsCompleted);
        var waiter = new TaskCompletionSource<bool>(TaskCreationOptions.RunContinuationsAsynchronously);
        _waiters.Add(waiter);
        return waiter;
    }

    /// <summary>Outside the lock, when the queue has let go of the object.</summary>
    public void Release(bool goesOn)
    {
        foreach (TaskCompletionSource<bool> waiter in _waiters)
            waiter.TrySetResult(goesOn);
    }
}
