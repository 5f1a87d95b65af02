using System;
using System.Runtime.CompilerServices;
using Rabit.Core.Messaging;

namespace Rabit.Core;

/// <summary>
/// The end of a publish-subscribe message that posts: fill in the local copy, then post it. Made by
/// <see cref="RabitManager.Publish{T}(string)"/>, or by <see cref="RabitWorkspace.Publish{T}(string)"/> for code outside managers.
/// </summary>
/// <typeparam name="T">A struct with value semantics, an immutable class, or a class that copies itself (<see cref="ISelfCopying{TSelf}"/>).</typeparam>
/// <remarks>Belongs to its manager: any use while that manager is not the one running on the calling thread is an error.</remarks>
public sealed class MessagePublisher<T>
{
    private readonly MessageBinding<T> _binding;

    internal MessagePublisher(MessageBinding<T> binding) => _binding = binding;

    /// <summary>The name of the message.</summary>
    public string Name => _binding.Name;

    /// <summary>
    /// The local copy, by reference: set the members of a struct or of a class that copies itself, or assign an immutable class as a
    /// whole. Nobody else sees it before it is posted.
    /// </summary>
    /// <exception cref="InvalidOperationException">The end's manager is not the one that runs on this thread, or nothing is wired yet.</exception>
    public ref T Value
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => ref _binding.Copy().Value;
    }

    /// <summary>The stamp of the last post or fetch behind the local copy.</summary>
    /// <exception cref="InvalidOperationException">See <see cref="Value"/>.</exception>
    public MessageStamp Stamp => _binding.Copy().Stamp;

    /// <summary>Copies the local to the global copy, stamped with the time of the clock, and wakes whoever asked for it.</summary>
    /// <remarks>Allocates nothing. Handlers of subscribers run on the calling thread before it returns.</remarks>
    /// <exception cref="InvalidOperationException">See <see cref="Value"/>.</exception>
    public void Post()
    {
        LocalCopy<T> copy = _binding.Copy();
        SharedMessage<T> shared = _binding.Shared!;
        TimeSpan now = shared.Clock.Now;
        shared.Post(copy, _binding.Owner, now, now);
    }

    /// <summary>As <see cref="Post()"/>, stamped with the time at which the value was true.</summary>
    /// <param name="trueAt">By the clock of the run (<see cref="RabitManager.Now"/>). Newness does not depend on it.</param>
    /// <exception cref="InvalidOperationException">See <see cref="Value"/>.</exception>
    public void Post(TimeSpan trueAt)
    {
        LocalCopy<T> copy = _binding.Copy();
        _binding.Shared!.Post(copy, _binding.Owner, trueAt);
    }
}
