namespace Rabit.Core.WakeUp;

/// <summary>
/// What ends a sleep: an operating system event for a thread, a place in the ready list for virtual time.
/// </summary>
internal interface IWakeSignal
{
    /// <summary>
    /// Called by a waker, on any thread, outside every lock of ours. A signal without a sleeper is kept for the next
    /// sleep.
    /// </summary>
    void Set();
}
