using System;
using System.Runtime.CompilerServices;
using System.Threading;
using System.Threading.Channels;
using System.Threading.Tasks;
using Rabit.Core.Queues;
using Rabit.Core.WakeUp;

namespace Rabit.Core;

/// <summary>
/// The endpoint of a message queue that pushes; there may be many. Made by <see cref="RabitManager.Send{T}"/>, or by
/// <see cref="RabitWorkspace.Send{T}"/> for code outside managers.
/// </summary>
/// <typeparam name="T">
/// Any type; a value is handed over, so a sender must not keep and change what it pushed.
/// </typeparam>
/// <remarks>
/// Belongs to its manager: any use while that manager is not the one running on the calling thread is an error.
/// </remarks>
/// <example>
/// <code>
/// if (_orders.Push(order) == PushResult.Rejected)
///     Log("the queue of orders is full");
/// </code>
/// </example>
public sealed class QueueSender<T>
{
    private readonly QueueBinding<T> _binding;

    internal QueueSender(QueueBinding<T> binding) => _binding = binding;

    /// <summary>The name of the queue.</summary>
    public string Name => _binding.Name;

    /// <summary>The counters of the queue at this instant.</summary>
    /// <exception cref="InvalidOperationException">
    /// The endpoint's manager is not the one that runs on this thread, or nothing is wired yet.
    /// </exception>
    public QueueCounters Counters => _binding.Use().Counters;

    /// <summary>
    /// Puts a value in, by the queue's rule for a full one, and wakes the receiver. Never waits, allocates nothing.
    /// </summary>
    /// <param name="value">The value.</param>
    /// <returns>What really happened.</returns>
    /// <exception cref="InvalidOperationException">
    /// See <see cref="Counters"/>; or the queue is one that makes its senders wait.
    /// </exception>
    public PushResult Push(in T value)
        => _binding.TryUse(out MessageQueue<T, SyncPoints> queue) ? queue.Push(value) : PushAfterCheck(value);

    /// <summary>
    /// Puts values in, one after the other, and wakes the receiver once. With <see cref="QueueFullMode.Reject"/> those
    /// that do not fit are rejected; with the rules that drop all are put in, and the values dropped for them are
    /// counted. Never waits, allocates nothing.
    /// </summary>
    /// <param name="values">The values, the first one first.</param>
    /// <returns>How many of them, from the first, were put in.</returns>
    /// <exception cref="InvalidOperationException">See <see cref="Push"/>.</exception>
    public int PushFrom(ReadOnlySpan<T> values)
        => _binding.TryUse(out MessageQueue<T, SyncPoints> queue)
            ? queue.PushFrom(values)
            : UseToPush().PushFrom(values);

    /// <summary>Whether a value is held that the queue rejected; see <see cref="TryPushOrHold"/>.</summary>
    /// <exception cref="InvalidOperationException">See <see cref="Counters"/>.</exception>
    public bool IsHolding
    {
        get
        {
            _binding.Use();
            return _binding.IsHolding;
        }
    }

    /// <summary>
    /// As <see cref="Push"/>, and holds a value that the queue rejects, for <see cref="TryPushHeld"/> in a later unit
    /// of work: the pop that makes room wakes this manager. So a full queue holds its senders back and loses nothing. A
    /// value that is still held at the end of the run is in <see cref="ReactorResult.Queues"/>.
    /// </summary>
    /// <param name="value">The value.</param>
    /// <returns>True when it is in the queue; false when it is held: take in nothing more for now.</returns>
    /// <exception cref="InvalidOperationException">
    /// A value is held already, or the endpoint was declared without <c>wakeOnPop</c>, or see <see cref="Push"/>.
    /// </exception>
    /// <example>
    /// <code>
    /// if (!_out.TryPushHeld())
    ///     return;                                // still full: the next pop wakes us
    /// while (_in.TryPop(out Order order))
    /// {
    ///     if (!_out.TryPushOrHold(order))
    ///         return;
    /// }
    /// </code>
    /// </example>
    public bool TryPushOrHold(in T value)
    {
        _binding.Use();
        if (!_binding.Wakes)
            throw new InvalidOperationException(
                $"A value for queue '{Name}' cannot be held: no pop would wake '{_binding.Owner.Name}' when there is "
                    + "room. Declare the endpoint with wakeOnPop: true.");
        if (_binding.IsHolding)
            throw new InvalidOperationException(
                $"'{_binding.Owner.Name}' holds a value for queue '{Name}' already: TryPushHeld comes first.");
        if (Push(value) != PushResult.Rejected)
            return true;
        _binding.Hold(value);
        return false;
    }

    /// <summary>Pushes the value that is held, if there is one.</summary>
    /// <returns>True when none is held any more.</returns>
    /// <remarks>Each attempt in vain is one that was rejected in the counters of the queue.</remarks>
    /// <exception cref="InvalidOperationException">See <see cref="Push"/>.</exception>
    public bool TryPushHeld()
    {
        if (!IsHolding)
            return true;
        if (Push(_binding.Held) == PushResult.Rejected)
            return false;
        _binding.ForgetHeld();
        return true;
    }

    /// <summary>
    /// As <see cref="Push"/>, and where the queue makes its senders wait it waits for room, as long as the queue
    /// allows. For code outside managers, one push after the other: those that wait are put in in their order. A push
    /// that waits allocates.
    /// </summary>
    /// <param name="value">The value; it stays the sender's if it was not put in.</param>
    /// <param name="cancellationToken">Ends the wait; the task is cancelled then, and the value not put in.</param>
    /// <returns>
    /// What really happened. <see cref="PushResult.Rejected"/> from a queue that makes its senders wait means that the
    /// run is over.
    /// </returns>
    /// <exception cref="InvalidOperationException">
    /// The endpoint belongs to a manager, which never waits, or nothing is wired yet.
    /// </exception>
    public ValueTask<PushResult> PushAsync(T value, CancellationToken cancellationToken = default)
    {
        _binding.DemandOutside();
        return _binding.Use().FullMode == QueueFullMode.Wait
            ? _binding.UseWaiting().PushAsync(value, cancellationToken)
            : new ValueTask<PushResult>(Push(value));
    }

    /// <summary>
    /// The endpoint as a channel, for async code outside managers. A write waits for room unless the queue drops; it
    /// fails with a <see cref="TimeoutException"/> after the queue's time limit, and with a
    /// <see cref="ChannelClosedException"/> when the run is over. Before the start only.
    /// </summary>
    /// <exception cref="InvalidOperationException">
    /// The endpoint belongs to a manager, or the reactor has started.
    /// </exception>
    public ChannelWriter<T> AsChannelWriter()
    {
        _binding.BecomeChannel();
        return new QueueChannelWriter<T>(_binding);
    }

    // Not inlined, and the last thing that is done: the hot path saves no registers for it.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private PushResult PushAfterCheck(in T value) => UseToPush().Push(value);

    private MessageQueue<T, SyncPoints> UseToPush()
    {
        MessageQueue<T, SyncPoints> queue = _binding.Use();
        if (queue.FullMode == QueueFullMode.Wait)
            throw new InvalidOperationException(
                $"Queue '{Name}' makes its senders wait: push into it with PushAsync, or through its channel.");
        return queue;
    }
}
