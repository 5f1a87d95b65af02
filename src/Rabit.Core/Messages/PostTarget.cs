using System;
using System.Threading;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;

namespace Rabit.Core.Messages;

/// <summary>
/// What a post sets off for one subscriber: a wake, a handler, or both. Disposed, it is a subscription that has ended.
/// </summary>
/// <remarks>
/// It may end before it is wired, while it is, and while posts go on. Under its own lock it learns which message it is
/// part of, or that it has ended; one of the two comes first, so it is either never added or taken out again.
/// </remarks>
internal sealed class PostTarget(EndpointOwner owner, WakeUpEvent? wakeUp, Action<MessageStamp>? handler) : IDisposable
{
    private readonly object _gate = new();
    private Action<PostTarget>? _takeOut;   // under _gate
    private bool _hasEnded;                 // written under _gate, read by posters

    public EndpointOwner Owner { get; } = owner;

    public WakeUpEvent? WakeUp { get; } = wakeUp;

    public Action<MessageStamp>? Handler { get; } = handler;

    public bool HasEnded => Volatile.Read(ref _hasEnded);

    /// <param name="takeOut">How it is taken out of its message.</param>
    /// <returns>False when it has ended.</returns>
    public bool TryJoin(Action<PostTarget> takeOut)
    {
        lock (_gate)
        {
            _takeOut = takeOut;
            return !_hasEnded;
        }
    }

    public void Dispose()
    {
        Action<PostTarget>? takeOut;
        lock (_gate)
        {
            Volatile.Write(ref _hasEnded, true);
            takeOut = _takeOut;
            _takeOut = null;
        }

        takeOut?.Invoke(this);
    }
}
