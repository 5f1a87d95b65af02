using System;
using System.Diagnostics.CodeAnalysis;
using Rabit.Core.Messaging;

namespace Rabit.Core;

/// <summary>The end of a message queue that pops; there is one. Made by <see cref="RabitManager.Receive{T}"/>.</summary>
/// <typeparam name="T">Any type; a value is handed over, so a sender must not keep and change what it pushed.</typeparam>
/// <remarks>Belongs to its manager: any use while that manager is not the one running on the calling thread is an error.</remarks>
public sealed class QueueReceiver<T>
{
    private readonly QueueBinding<T> _binding;

    internal QueueReceiver(QueueBinding<T> binding) => _binding = binding;

    /// <summary>The name of the queue.</summary>
    public string Name => _binding.Name;

    /// <summary>How many values are in the queue; more may come while one looks.</summary>
    /// <exception cref="InvalidOperationException">The end's manager is not the one that runs on this thread, or nothing is wired yet.</exception>
    public int Count => _binding.Use().Count;

    /// <summary>The books of the queue at this instant.</summary>
    /// <exception cref="InvalidOperationException">See <see cref="Count"/>.</exception>
    public QueueCounters Counters => _binding.Use().Counters;

    /// <summary>Takes the oldest value out; wakes the senders that asked for it. Never waits, allocates nothing.</summary>
    /// <param name="value">The value; default when there is none.</param>
    /// <returns>False when the queue is empty.</returns>
    /// <exception cref="InvalidOperationException">See <see cref="Count"/>.</exception>
    public bool TryPop([MaybeNullWhen(false)] out T value) => _binding.Use().TryPop(out value);
}
