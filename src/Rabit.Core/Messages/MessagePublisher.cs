using System;
using System.Runtime.CompilerServices;
using Rabit.Core.Messages;

namespace Rabit.Core;

/// <summary>
/// The endpoint of a publish-subscribe message that posts: fill in the local copy, then post it. Made by
/// <see cref="RabitManager.Publish{T}(string)"/>, or by <see cref="RabitWorkspace.Publish{T}(string)"/> for code
/// outside managers.
/// </summary>
/// <typeparam name="T">
/// A struct with value semantics, an immutable class, or a class that copies itself
/// (<see cref="ISelfCopying{TSelf}"/>).
/// </typeparam>
/// <remarks>
/// Belongs to its manager: any use while that manager is not the one running on the calling thread is an error.
/// </remarks>
/// <example>
/// <code>
/// _pose.Value.NorthMetres = 12;   // one member of the local copy
/// _pose.Post();
///
/// _pose.Post(new Pose { NorthMetres = 12 });   // or the whole value
/// </code>
/// </example>
public sealed class MessagePublisher<T>
{
    private readonly MessageBinding<T> _binding;

    internal MessagePublisher(MessageBinding<T> binding) => _binding = binding;

    /// <summary>The name of the message.</summary>
    public string Name => _binding.Name;

    /// <summary>
    /// The local copy, by reference: set the members of a struct or of a class that copies itself, or assign an
    /// immutable class as a whole. No other manager sees it before it is posted.
    /// </summary>
    /// <exception cref="InvalidOperationException">
    /// The endpoint's manager is not the one that runs on this thread, or nothing is wired yet.
    /// </exception>
    public ref T Value
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => ref _binding.Copy().Value;
    }

    /// <summary>The stamp of the last post or fetch behind the local copy.</summary>
    /// <exception cref="InvalidOperationException">See <see cref="Value"/>.</exception>
    public MessageStamp Stamp => _binding.Copy().Stamp;

    /// <summary>
    /// Copies the local to the global copy, stamped with the time of the clock, and wakes the subscribers that asked
    /// for it.
    /// </summary>
    /// <remarks>Allocates nothing. Handlers of subscribers run on the calling thread before it returns.</remarks>
    /// <exception cref="InvalidOperationException">See <see cref="Value"/>.</exception>
    public void Post()
    {
        LocalCopy<T> copy = _binding.Copy();
        SharedMessage<T> shared = _binding.Shared!;
        TimeSpan now = shared.Clock.Now;
        shared.Post(copy, _binding.Owner, now, now);
    }

    /// <summary>
    /// Copies a value to the local copy, and posts that: for languages and closures without references.
    /// </summary>
    /// <param name="value">
    /// The value. An instance of a class that copies itself is copied (<see cref="ISelfCopying{TSelf}.CopyTo"/>) and
    /// stays the caller's.
    /// </param>
    /// <remarks>As <see cref="Post()"/>.</remarks>
    /// <exception cref="InvalidOperationException">
    /// See <see cref="Value"/>; or a class that copies itself failed to.
    /// </exception>
    public void Post(in T value)
    {
        LocalCopy<T> copy = Assign(value);
        SharedMessage<T> shared = _binding.Shared!;
        TimeSpan now = shared.Clock.Now;
        shared.Post(copy, _binding.Owner, now, now);
    }

    /// <summary>As <see cref="Post()"/>, stamped with the time at which the value was true.</summary>
    /// <param name="trueAt">
    /// By the clock of the run (<see cref="RabitManager.Now"/>). Newness does not depend on it.
    /// </param>
    /// <exception cref="InvalidOperationException">See <see cref="Value"/>.</exception>
    public void PostStamped(TimeSpan trueAt)
    {
        LocalCopy<T> copy = _binding.Copy();
        _binding.Shared!.Post(copy, _binding.Owner, trueAt);
    }

    /// <summary>As <see cref="Post(in T)"/>, stamped with the time at which the value was true.</summary>
    /// <param name="value">The value.</param>
    /// <param name="trueAt">
    /// By the clock of the run (<see cref="RabitManager.Now"/>). Newness does not depend on it.
    /// </param>
    /// <exception cref="InvalidOperationException">See <see cref="Post(in T)"/>.</exception>
    public void PostStamped(in T value, TimeSpan trueAt)
    {
        LocalCopy<T> copy = Assign(value);
        _binding.Shared!.Post(copy, _binding.Owner, trueAt);
    }

    // Checks whose thread it is, once for the assignment and the post.
    private LocalCopy<T> Assign(in T value)
    {
        LocalCopy<T> copy = _binding.Copy();
        _binding.Shared!.Assign(copy, value);
        return copy;
    }
}
