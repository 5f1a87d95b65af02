using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;
using Rabit.Core.Workspaces;

namespace Rabit.Core.Messaging;

/// <summary>
/// What an owner declared of a message, and, once wired, its tie to the hidden global copy. Written by the thread that wires;
/// then read by the owner's thread.
/// </summary>
internal sealed class MessageBinding<T>(EndOwner owner, EndRole role, string name) : EndDeclaration(owner, role, name, typeof(T))
{
    private List<Action<MessageStamp>>? _handlers;
    private LocalCopy<T>? _copy;

    /// <summary>The value before the first post, where this end states one.</summary>
    public T Initial { get; init; } = default!;

    public SharedMessage<T>? Shared { get; private set; }

    public override bool IsWired => Shared is not null;

    /// <summary>The local copy, after the check that the owner may use it: the hot path of every end.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public LocalCopy<T> Copy()
    {
        LocalCopy<T>? copy = _copy;
        if (copy is null || (RunningManager.Current != Owner && Owner.IsManager))
            ThrowMisuse();
        return copy!;
    }

    public void AddHandler(Action<MessageStamp> handler)
    {
        if (Shared is null)
            (_handlers ??= []).Add(handler);
        else
            Shared.AddTarget(new PostTarget(Owner, wakeUp: null, handler));
    }

    public override object CreateHub(IReadOnlyList<EndDeclaration> ends, RunClock clock, RabitLog log)
    {
        T initial = default!;
        foreach (EndDeclaration end in ends)
        {
            if (end.StatesInitial)
                initial = ((MessageBinding<T>)end).Initial;
        }

        return new SharedMessage<T>(Name, initial, clock, log);
    }

    public override void Watch(object hub, EventLog events)
    {
        // A manager posts its status after every run, which the log tells of already.
        if (!IsBuiltIn)
            ((SharedMessage<T>)hub).AddTarget(new PostTarget(events.Owner, wakeUp: null, stamp => events.Posted(Name, stamp)));
    }

    public override void Bind(object hub, EndDeclaration? firstOfOwner)
    {
        Shared = (SharedMessage<T>)hub;

        // All ends of a manager for one message share its local copy; ends outside managers have one each.
        _copy = Owner.IsManager && firstOfOwner is MessageBinding<T> first ? first._copy! : Shared.CreateCopy();
        if (Role != EndRole.Subscribe)
            return;
        if (Wakes)
            Shared.AddTarget(new PostTarget(Owner, Owner.WakeUp, handler: null));
        if (_handlers is null)
            return;
        foreach (Action<MessageStamp> handler in _handlers)
            Shared.AddTarget(new PostTarget(Owner, wakeUp: null, handler));
    }
}
