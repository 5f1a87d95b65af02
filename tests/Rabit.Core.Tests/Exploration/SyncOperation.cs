using System;

namespace Rabit.Core.Tests.Exploration;

/// <summary>One operation of a thread: what, where (a location or a signal, by number) and with which values.</summary>
internal readonly record struct SyncOperation(SyncKind Kind, int Location = 0, int Value = 0, int Comparand = 0)
{
    /// <summary>How long the wait for an event may take.</summary>
    public TimeSpan AtMost { get; init; }

    /// <summary>When the wait on a futex ends at the latest.</summary>
    public TimeSpan Until { get; init; }

    /// <summary>What a note does to the model's own numbers; null for the others.</summary>
    public Action<ExploredState>? Note { get; init; }

    /// <summary>Whether the step that this note belongs to may as well never come: no code may count on it.</summary>
    public bool MayNeverCome { get; init; }

    /// <summary>What distinguishes a note from others; compared.</summary>
    public object? About { get; init; }

    /// <summary>Whether the two are the same operation, their notes apart.</summary>
    public bool IsLike(in SyncOperation other) => this with { Note = null } == other with { Note = null };
}
