using System;
using System.Collections.Generic;
using System.Diagnostics.CodeAnalysis;
using Rabit.Core.Diagnostics;
using Rabit.Core.Managers;

namespace Rabit.Core.Workspaces;

/// <summary>What a constructor records of one end of a message or queue; bound when the workspace is wired.</summary>
internal abstract class EndDeclaration(EndOwner owner, EndRole role, string name, Type valueType)
{
    public EndOwner Owner { get; } = owner;

    public EndRole Role { get; } = role;

    public string Name { get; } = name;

    public Type ValueType { get; } = valueType;

    /// <summary>A subscriber that is woken by posts, a receiver by pushes, a sender by pops.</summary>
    public bool Wakes { get; init; }

    /// <summary>A subscriber that can live without a publisher.</summary>
    public bool IsOptional { get; init; }

    /// <summary>A publisher that allows others beside it.</summary>
    public bool IsShared { get; init; }

    /// <summary>An end that says what the value is before the first post.</summary>
    public bool StatesInitial { get; init; }

    /// <summary>A message that the library itself posts; nobody needs to read it.</summary>
    public bool IsBuiltIn { get; init; }

    public bool IsMessage => Role is EndRole.Publish or EndRole.Subscribe;

    public abstract bool IsWired { get; }

    /// <summary>Makes what joins all ends of this name.</summary>
    public abstract object CreateHub(IReadOnlyList<EndDeclaration> ends, RunClock clock, RabitLog log);

    /// <param name="hub">What <see cref="CreateHub"/> made.</param>
    /// <param name="firstOfOwner">The end of the same owner and name that was bound first, if this is not it.</param>
    public abstract void Bind(object hub, EndDeclaration? firstOfOwner);

    /// <summary>Lets the event log know of what goes through this message or queue.</summary>
    /// <param name="hub">What <see cref="CreateHub"/> made, before anything is bound to it.</param>
    /// <param name="events">The event log.</param>
    public abstract void Watch(object hub, EventLog events);

    [DoesNotReturn]
    protected void ThrowMisuse()
    {
        string what = IsMessage ? "message" : "queue";
        string running = RunningManager.Current is { } current ? $"manager '{current.Name}' is" : "no manager is";
        throw new InvalidOperationException(IsWired
            ? $"The end of {what} '{Name}' belongs to manager '{Owner.Name}', but {running} running on this thread."
            : $"The end of {what} '{Name}' of '{Owner.Name}' cannot be used before the reactor has started.");
    }
}
