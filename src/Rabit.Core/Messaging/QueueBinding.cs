using System.Collections.Generic;
using System.Runtime.CompilerServices;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;
using Rabit.Core.Workspaces;

namespace Rabit.Core.Messaging;

/// <summary>What an owner declared of a queue, and, once wired, its tie to it. Written by the thread that wires; then read by the owner's thread.</summary>
internal sealed class QueueBinding<T>(EndOwner owner, EndRole role, string name) : EndDeclaration(owner, role, name, typeof(T)), IQueueDeclaration
{
    /// <summary>Stated by the receiver.</summary>
    public int Capacity { get; init; }

    /// <summary>Stated by the receiver.</summary>
    public QueueFullMode FullMode { get; init; }

    public MessageQueue<T>? Queue { get; private set; }

    public override bool IsWired => Queue is not null;

    /// <summary>The queue, after the check that the owner may use it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public MessageQueue<T> Use()
    {
        MessageQueue<T>? queue = Queue;
        if (queue is null || (RunningManager.Current != Owner && Owner.IsManager))
            ThrowMisuse();
        return queue!;
    }

    public override object CreateHub(IReadOnlyList<EndDeclaration> ends, RunClock clock, RabitLog log)
    {
        QueueBinding<T> receiver = this;
        foreach (EndDeclaration end in ends)
        {
            if (end.Role == EndRole.Receive)
                receiver = (QueueBinding<T>)end;
        }

        return new MessageQueue<T>(Name, receiver.Capacity, receiver.FullMode, receiver.Wakes ? receiver.Owner.WakeUp : null, log);
    }

    public override void Watch(object hub, EventLog events) => events.Watch((IMessageQueue)hub);

    public override void Bind(object hub, EndDeclaration? firstOfOwner)
    {
        Queue = (MessageQueue<T>)hub;
        if (Role == EndRole.Send && Wakes && Owner.WakeUp is { } wakeUp)
            Queue.AddPopTarget(wakeUp);
    }
}
