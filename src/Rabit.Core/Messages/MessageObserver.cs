using System;
using System.Diagnostics.CodeAnalysis;

namespace Rabit.Core;

/// <summary>
/// Reads a message of any type, for tools that know it by name only. Made by
/// <see cref="RabitWorkspace.ObserveMessages"/>; one thread at a time. It is no subscriber: it is in no wiring, wakes
/// nothing, and a post does not know of it.
/// </summary>
public abstract class MessageObserver
{
    private protected MessageObserver(string name, Type valueType)
    {
        Name = name;
        ValueType = valueType;
    }

    /// <summary>The name of the message.</summary>
    public string Name { get; }

    /// <summary>The type of its values.</summary>
    public Type ValueType { get; }

    /// <summary>
    /// The stamp of the latest post, without its value: no user code runs, and a poster is held up no longer than by a
    /// fetch. Version zero before the first post.
    /// </summary>
    public abstract MessageStamp ReadStamp();

    /// <summary>
    /// The latest value, whole, in a copy that belongs to this observer: a struct boxed, an immutable object itself, of
    /// a class that copies itself an instance that is valid until the next call.
    /// </summary>
    /// <param name="stamp">
    /// Its stamp; version zero where nothing was posted yet, and the value is the initial one.
    /// </param>
    /// <returns>Null only where null was posted.</returns>
    /// <exception cref="InvalidOperationException">The class copies itself, and that failed.</exception>
    [SuppressMessage("Design", "CA1021:Avoid out parameters", Justification = "A value and its stamp belong together.")]
    public abstract object? ReadValue(out MessageStamp stamp);
}
