using System;
using Rabit.Core.Managers;

namespace Rabit.Core.Messaging;

/// <summary>What a post sets off for one subscriber: a wake, a handler, or both.</summary>
internal sealed class PostTarget(EndOwner owner, WakeUpEvent? wakeUp, Action<MessageStamp>? handler)
{
    public EndOwner Owner { get; } = owner;

    public WakeUpEvent? WakeUp { get; } = wakeUp;

    public Action<MessageStamp>? Handler { get; } = handler;
}
