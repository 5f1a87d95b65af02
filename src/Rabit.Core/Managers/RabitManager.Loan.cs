namespace Rabit.Core;

/// <content>Units of work on the threads of readers.</content>
public abstract partial class RabitManager
{
    /// <summary>
    /// Whether a reader of this manager that has read a value while the manager sleeps runs the unit of work itself, on
    /// its own thread, instead of waking the manager's: a value then costs the wake-up of one thread, not of two. There
    /// is still one unit of work at a time, and each sees what the one before did; but it may not rely on the thread it
    /// runs on (its priority, its CPU, thread-local storage), and a reader reads nothing while it runs. Set in the
    /// constructor; false by default. It is not done with a <see cref="Period"/> or <see cref="SpinBeforeSleep"/>, for
    /// readers whose queue waits for room, and in virtual time.
    /// </summary>
    public bool RunsOnReaders { get; protected set; }
}
