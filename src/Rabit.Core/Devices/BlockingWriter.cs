using System;
using Rabit.Core.Devices;

namespace Rabit.Core;

/// <summary>
/// A writer that a manager owns: a thread of the library's that takes what the manager pushes and writes it to a
/// target, so that a slow device never holds the manager up. Made by <see cref="RabitManager.AttachWriter{T}"/>.
/// </summary>
/// <typeparam name="T">What one write takes.</typeparam>
/// <remarks>
/// It is stopped after its manager's shutdown, when it has written what was left. A target that throws ends the writer,
/// or is opened again (<see cref="ReconnectPolicy"/>); the fault is in the log, and the manager is woken
/// (<see cref="WakeUpCauses.Device"/>) whenever the state changes. What is pushed after that stays in the queue.
/// </remarks>
public sealed class BlockingWriter<T>
{
    private readonly QueueSender<T> _queue;
    private readonly DeviceHealth _health;

    internal BlockingWriter(string name, QueueSender<T> queue, DeviceHealth health)
    {
        Name = name;
        _queue = queue;
        _health = health;
    }

    /// <summary>Its name, within the manager.</summary>
    public string Name { get; }

    /// <summary>Where it is in its life. Any thread.</summary>
    public DeviceState State => _health.State;

    /// <summary>Since when it is there, by <see cref="RabitManager.Now"/>. Any thread.</summary>
    public TimeSpan StateSince => _health.Since;

    /// <summary>The last exception of its device; null when there was none. Any thread.</summary>
    public Exception? Fault => _health.Fault;

    /// <summary>How many exceptions its device threw. Any thread.</summary>
    public long Faults => _health.Faults;

    /// <summary>How many times its device was opened again after a fault. Any thread.</summary>
    public long Reconnects => _health.Reconnects;

    /// <summary>
    /// Values that were not written, because the target threw at them or the writer ended first. Any thread.
    /// </summary>
    public long Discarded => _health.Discarded;

    /// <summary>The counters of the queue. The manager's thread only.</summary>
    public QueueCounters Counters => _queue.Counters;

    /// <summary>Hands a value to the writer. The manager's thread only; never waits.</summary>
    /// <param name="value">The value.</param>
    /// <returns>What really happened.</returns>
    /// <exception cref="InvalidOperationException">
    /// The manager is not the one that runs on this thread, or nothing is wired yet.
    /// </exception>
    public PushResult Push(in T value) => _queue.Push(value);
}
