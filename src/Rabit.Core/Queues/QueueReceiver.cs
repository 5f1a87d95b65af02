using System;
using System.Diagnostics.CodeAnalysis;
using System.Runtime.CompilerServices;
using System.Threading.Channels;
using Rabit.Core.Queues;
using Rabit.Core.WakeUp;

namespace Rabit.Core;

/// <summary>
/// The endpoint of a message queue that pops; there is one. Made by <see cref="RabitManager.Receive{T}"/>, or by
/// <see cref="RabitWorkspace.Receive{T}"/> for code outside managers, where one thread at a time may use it.
/// </summary>
/// <typeparam name="T">
/// Any type; a value is handed over, so a sender must not keep and change what it pushed.
/// </typeparam>
/// <remarks>
/// Belongs to its manager: any use while that manager is not the one running on the calling thread is an error.
/// </remarks>
/// <example>
/// <code>
/// while (_orders.TryPop(out Order order))
///     Execute(order);
/// </code>
/// </example>
public sealed class QueueReceiver<T>
{
    private readonly QueueBinding<T> _binding;

    internal QueueReceiver(QueueBinding<T> binding) => _binding = binding;

    /// <summary>The name of the queue.</summary>
    public string Name => _binding.Name;

    /// <summary>How many values are in the queue; more may come while one looks.</summary>
    /// <exception cref="InvalidOperationException">
    /// The endpoint's manager is not the one that runs on this thread, or nothing is wired yet.
    /// </exception>
    public int Count => _binding.Use().Count;

    /// <summary>The counters of the queue at this instant.</summary>
    /// <exception cref="InvalidOperationException">See <see cref="Count"/>.</exception>
    public QueueCounters Counters => _binding.Use().Counters;

    /// <summary>
    /// Takes the oldest value out; wakes the senders that asked for it. Never waits, allocates nothing.
    /// </summary>
    /// <param name="value">The value; default when there is none.</param>
    /// <returns>False when the queue is empty.</returns>
    /// <exception cref="InvalidOperationException">See <see cref="Count"/>.</exception>
    public bool TryPop([MaybeNullWhen(false)] out T value)
        => _binding.TryUse(out MessageQueue<T, SyncPoints> queue)
            ? queue.TryPop(out value)
            : TryPopAfterCheck(out value);

    /// <summary>
    /// Takes values out, the oldest first, as many as there are and fit; wakes the senders that asked for it once.
    /// Never waits, allocates nothing.
    /// </summary>
    /// <param name="target">Where they go, from its beginning.</param>
    /// <returns>How many were taken out.</returns>
    /// <exception cref="InvalidOperationException">See <see cref="Count"/>.</exception>
    public int PopInto(Span<T> target)
        => _binding.TryUse(out MessageQueue<T, SyncPoints> queue)
            ? queue.PopInto(target)
            : _binding.Use().PopInto(target);

    // Not inlined, and the last thing that is done: the hot path saves no registers for it.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool TryPopAfterCheck([MaybeNullWhen(false)] out T value) => _binding.Use().TryPop(out value);

    /// <summary>
    /// The endpoint as a channel, for async code outside managers. It completes when the run is over and everything was
    /// read. Before the start only.
    /// </summary>
    /// <exception cref="InvalidOperationException">
    /// The endpoint belongs to a manager, or the reactor has started.
    /// </exception>
    public ChannelReader<T> AsChannelReader()
    {
        _binding.BecomeChannel();
        return new QueueChannelReader<T>(_binding);
    }
}
