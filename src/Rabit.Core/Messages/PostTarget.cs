using System;
using Rabit.Core.WakeUp;
using Rabit.Core.Wiring;

namespace Rabit.Core.Messages;

/// <summary>
/// What a post sets off for one subscriber: a wake, a handler, or both. Disposed, it is a subscription that has ended.
/// </summary>
internal sealed class PostTarget(EndpointOwner owner, WakeUpEvent? wakeUp, Action<MessageStamp>? handler)
    : Subscription<SyncPoints>
{
    public EndpointOwner Owner { get; } = owner;

    public WakeUpEvent? WakeUp { get; } = wakeUp;

    public Action<MessageStamp>? Handler { get; } = handler;
}
