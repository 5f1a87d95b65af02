using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;
using Rabit.Core.Time;
using Rabit.Core.Wiring;

namespace Rabit.Core.Messages;

/// <summary>
/// What an owner declared of a message, and, once wired, the hidden global copy. Written by the thread that wires;
/// then read by the owner's thread.
/// </summary>
internal sealed class MessageBinding<T>(EndpointOwner owner, EndpointRole role, string name)
    : EndpointDeclaration(owner, role, name, typeof(T))
{
    // Whether T is a class that copies itself. The same for all messages of a type, and known without reflection on
    // members.
    private static readonly bool IsSelfCopying = !typeof(T).IsValueType
        && typeof(ISelfCopying<T>).IsAssignableFrom(typeof(T));

    // Who must run on the thread that uses this endpoint: null outside managers.
    private readonly EndpointOwner? _mustRun = owner.IsManager ? owner : null;

    // Code outside managers adds handlers at any time, also while another thread wires.
    private readonly object _handlersGate = new();
    private List<PostTarget>? _handlers;   // until it is wired, under the gate
    private LocalCopy<T>? _copy;

    /// <summary>The value before the first post, where this endpoint states one.</summary>
    public T Initial { get; init; } = default!;

    /// <summary>Whether its first post allocates what it takes to post: one that never posts has none.</summary>
    public bool PostsRarely { get; init; }

    public SharedMessage<T>? Shared { get; private set; }

    public override bool IsWired => Shared is not null;

    public override bool CopiesItself => IsSelfCopying;

    /// <summary>The local copy, after the check that the owner may use it: the hot path of every endpoint.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public LocalCopy<T> Copy()
    {
        LocalCopy<T>? copy = _copy;
        if (copy is null || (_mustRun is not null && !RunningManager.Is(_mustRun)))
            ThrowMisuse();
        return copy!;
    }

    /// <summary>Async code resumes on any thread, so it cannot use the endpoint of a manager.</summary>
    public void DemandOutside()
    {
        if (!Owner.IsOutside)
            throw new InvalidOperationException(
                $"The endpoint of message '{Name}' belongs to '{Owner.Name}': async code gets an endpoint of its own "
                    + "from the workspace.");
    }

    /// <returns>Disposed, it ends.</returns>
    public IDisposable AddHandler(Action<MessageStamp> handler)
    {
        var target = new PostTarget(Owner, wakeUp: null, handler);
        lock (_handlersGate)
        {
            if (Shared is null)
                (_handlers ??= []).Add(target);
            else
                target.Join(Shared);
        }

        return target;
    }

    public override string? FindFaultOfInitial()
    {
        if (!IsSelfCopying || Initial is null)
            return null;
        string method = $"{TypeNames.Of(typeof(T))}.{nameof(ISelfCopying<>.Clone)}";
        try
        {
            T clone = ((ISelfCopying<T>)Initial).Clone();
            if (clone is null)
                return $"{method} gives null.";
            return ReferenceEquals(clone, Initial)
                ? $"{method} gives the same instance, which copies would share."
                : null;
        }
        catch (Exception e)
        {
            // The user's method; reported with all other faults of the wiring.
            return $"{method} threw {ExceptionText.Describe(e)}";
        }
    }

    public override IConnector CreateConnector(
        IReadOnlyList<EndpointDeclaration> endpoints, RunClock clock, RabitLog log)
    {
        T initial = default!;
        int publishers = 0;
        foreach (EndpointDeclaration endpoint in endpoints)
        {
            if (endpoint.StatesInitial)
                initial = ((MessageBinding<T>)endpoint).Initial;
            if (endpoint.Role == EndpointRole.Publish)
                publishers++;
        }

        var place = new MessagePlace(Name, clock, log);
        if (IsSelfCopying && initial is not null)
            return new SharedObject<T>(place, initial);

        // A manager posts on one thread at a time; code outside managers is held to it by every post.
        return new SharedValue<T>(place, initial, isAlone: publishers == 1);
    }

    public override void Watch(IConnector connector, EventLog events)
    {
        // A manager posts its status after every run, which is in the log already.
        if (!IsBuiltIn)
            new PostTarget(events.Owner, wakeUp: null, stamp => events.Posted(Name, stamp))
                .Join((SharedMessage<T>)connector);
    }

    public override void Bind(IConnector connector, EndpointDeclaration? firstOfOwner)
    {
        var shared = (SharedMessage<T>)connector;

        // All endpoints of a manager for one message share its local copy; endpoints outside managers have one each.
        LocalCopy<T> copy = Owner.IsManager && firstOfOwner is MessageBinding<T> first
            ? first._copy!
            : shared.CreateCopy();
        if (Role == EndpointRole.Publish && !PostsRarely)
            shared.Equip(copy, Owner);

        // One section, so that a handler that another thread adds meanwhile either is among them or joins after them.
        lock (_handlersGate)
        {
            Shared = shared;
            _copy = copy;
            if (Wakes && Role == EndpointRole.Subscribe)
                new PostTarget(Owner, Owner.WakeUp, handler: null).Join(shared);
            foreach (PostTarget target in _handlers ?? [])
                target.Join(shared);
            _handlers = null;
        }
    }
}
