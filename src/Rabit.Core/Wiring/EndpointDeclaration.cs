using System;
using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;
using Rabit.Core.Time;

namespace Rabit.Core.Wiring;

/// <summary>
/// What a constructor records of one endpoint of a message or queue; bound when the workspace is wired.
/// </summary>
internal abstract class EndpointDeclaration(EndpointOwner owner, EndpointRole role, string name, Type valueType)
{
    public EndpointOwner Owner { get; } = owner;

    public EndpointRole Role { get; } = role;

    public string Name { get; } = name;

    public Type ValueType { get; } = valueType;

    /// <summary>A subscriber that is woken by posts, a receiver by pushes, a sender by pops.</summary>
    public bool Wakes { get; init; }

    /// <summary>A subscriber that can live without a publisher.</summary>
    public bool IsOptional { get; init; }

    /// <summary>A publisher that allows others beside it.</summary>
    public bool IsShared { get; init; }

    /// <summary>An endpoint that says what the value is before the first post.</summary>
    public bool StatesInitial { get; init; }

    /// <summary>A message that the library itself posts; it needs no subscriber.</summary>
    public bool IsBuiltIn { get; init; }

    /// <summary>A message of a class that copies itself.</summary>
    public virtual bool CopiesItself => false;

    public bool IsMessage => Role is EndpointRole.Publish or EndpointRole.Subscribe;

    public abstract bool IsWired { get; }

    /// <summary>What is wrong with the value before the first post; null where nothing is, or none is stated.</summary>
    public virtual string? FindFaultOfInitial() => null;

    /// <summary>Makes what joins all endpoints of this name.</summary>
    public abstract IConnector CreateConnector(
        IReadOnlyList<EndpointDeclaration> endpoints, RunClock clock, RabitLog log);

    /// <param name="connector">What <see cref="CreateConnector"/> made.</param>
    /// <param name="firstOfOwner">
    /// The endpoint of the same owner and name that was bound first, if this is not it.
    /// </param>
    public abstract void Bind(IConnector connector, EndpointDeclaration? firstOfOwner);

    /// <summary>Lets the event log know of what goes through this message or queue.</summary>
    /// <param name="connector">What <see cref="CreateConnector"/> made, before anything is bound to it.</param>
    /// <param name="events">The event log.</param>
    public abstract void Watch(IConnector connector, EventLog events);

    [DoesNotReturn]
    protected void ThrowMisuse()
    {
        string what = IsMessage ? "message" : "queue";
        string running = RunningManager.Current is { } current ? $"manager '{current.Name}' is" : "no manager is";
        throw new InvalidOperationException(IsWired
            ? $"The endpoint of {what} '{Name}' belongs to manager '{Owner.Name}', but {running} running on this "
                + "thread."
            : $"The endpoint of {what} '{Name}' of '{Owner.Name}' cannot be used before the reactor has started.");
    }
}
