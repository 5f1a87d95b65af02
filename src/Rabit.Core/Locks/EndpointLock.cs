using System;
using System.Threading;

namespace Rabit.Core.Locks;

/// <summary>
/// The lock of a queue, of a pool of buffers or of the watchdog's posts: <c>using (_lock.Enter())</c>. A thread that
/// holds it may enter it again.
/// </summary>
/// <remarks>
/// A thread of a high real-time priority may have to wait for one of a low priority that holds it. So that no thread of
/// a priority in between can keep it waiting (priority inversion), the lock lends the holder the priority of those who
/// wait: see <see cref="PriorityInheritanceMutex"/>. Where no manager can have asked for one it is an ordinary
/// monitor, which is faster where many threads meet in it, since it spins for longer.
/// </remarks>
internal sealed class EndpointLock
{
    private readonly PriorityInheritanceMutex? _mutex;

    /// <param name="inheritsPriority">Whether managers of a real-time priority may use it.</param>
    public EndpointLock(bool inheritsPriority)
        => _mutex = inheritsPriority && PriorityInheritanceMutex.IsThere ? new PriorityInheritanceMutex() : null;

    /// <summary>Whether it lends its holder the priority of those who wait.</summary>
    public bool InheritsPriority => _mutex is not null;

    /// <summary>Waits until no other thread holds the lock, and holds it until the result is disposed.</summary>
    public Holder Enter()
    {
        if (_mutex is null)
            Monitor.Enter(this);
        else
            _mutex.Enter();
        return new Holder(this);
    }

    private void Exit()
    {
        if (_mutex is null)
            Monitor.Exit(this);
        else
            _mutex.Exit();
    }

    /// <summary>The calling thread's hold of the lock. Disposed once, by that thread.</summary>
    public readonly struct Holder(EndpointLock held) : IDisposable
    {
        public void Dispose() => held.Exit();
    }
}
