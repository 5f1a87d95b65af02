using System;
using System.Diagnostics.CodeAnalysis;
using System.Threading;
using Rabit.Core.Devices;

namespace Rabit.Core;

/// <summary>
/// A reader that a manager owns: a thread of the library's that reads a source and hands what it read to the manager
/// through a queue, waking it. Made by <see cref="RabitManager.AttachReader{T}"/>.
/// </summary>
/// <typeparam name="T">What one read gives.</typeparam>
/// <remarks>
/// It opens its source when all managers have started, and is stopped before its manager shuts down. A source that
/// throws ends the reader, or is opened again (<see cref="ReconnectPolicy"/>); the fault is in the log, and the manager
/// is woken (<see cref="WakeUpCauses.Device"/>) whenever the state changes.
/// </remarks>
/// <example>
/// <code>
/// public sealed class Gps : RabitManager
/// {
///     private readonly BlockingReader&lt;string&gt; _lines;
///
///     // NmeaSource is an IReaderSource&lt;string&gt; that reads a serial line.
///     public Gps() : base("gps")
///         =&gt; _lines = AttachReader("nmea", new NmeaSource("/dev/ttyUSB0"), reconnect: ReconnectPolicy.Always);
///
///     protected override void ExecuteUnitOfWork()
///     {
///         while (_lines.TryPop(out string? line))
///             Log(line);
///     }
/// }
/// </code>
/// </example>
public sealed class BlockingReader<T>
{
    private readonly QueueReceiver<T> _queue;
    private readonly DeviceHealth _health;

    internal BlockingReader(string name, QueueReceiver<T> queue, DeviceHealth health)
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
    /// Values that were read and are lost, because the run was stopped while the queue was full. Any thread.
    /// </summary>
    public long Discarded => _health.Discarded;

    /// <summary>The counters of the queue. The manager's thread only.</summary>
    public QueueCounters Counters => _queue.Counters;

    /// <summary>Takes the oldest value that was read. The manager's thread only; never waits.</summary>
    /// <param name="value">The value; default when there is none.</param>
    /// <returns>False when there is none.</returns>
    /// <exception cref="InvalidOperationException">
    /// The manager is not the one that runs on this thread, or nothing is wired yet.
    /// </exception>
    public bool TryPop([MaybeNullWhen(false)] out T value) => _queue.TryPop(out value);
}
