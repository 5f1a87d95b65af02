using System;
using Rabit.Core.Messaging;

namespace Rabit.Core;

/// <summary>
/// The end of a message queue that pushes; there may be many. Made by <see cref="RabitManager.Send{T}"/>, or by
/// <see cref="RabitWorkspace.Send{T}"/> for code outside managers.
/// </summary>
/// <typeparam name="T">Any type; a value is handed over, so a sender must not keep and change what it pushed.</typeparam>
/// <remarks>Belongs to its manager: any use while that manager is not the one running on the calling thread is an error.</remarks>
public sealed class QueueSender<T>
{
    private readonly QueueBinding<T> _binding;

    internal QueueSender(QueueBinding<T> binding) => _binding = binding;

    /// <summary>The name of the queue.</summary>
    public string Name => _binding.Name;

    /// <summary>The books of the queue at this instant.</summary>
    /// <exception cref="InvalidOperationException">The end's manager is not the one that runs on this thread, or nothing is wired yet.</exception>
    public QueueCounters Counters => _binding.Use().Counters;

    /// <summary>Puts a value in, by the queue's rule for a full one, and wakes the receiver. Never waits, allocates nothing.</summary>
    /// <param name="value">The value.</param>
    /// <returns>What really happened.</returns>
    /// <exception cref="InvalidOperationException">See <see cref="Counters"/>.</exception>
    public PushResult Push(in T value) => _binding.Use().Push(value);
}
