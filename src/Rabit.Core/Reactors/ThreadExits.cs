using System;
using System.Threading;

namespace Rabit.Core.Reactors;

/// <summary>
/// Lets threads that have ended exit when the run is over. An exit takes the kernel and the runtime several times what
/// a shutdown takes, on the CPU on which the next manager of the order is to shut down.
/// </summary>
/// <remarks>
/// Each lets the next one go: to wake all at once would take the reactor as long as their exits, since each that is
/// woken may displace it.
/// </remarks>
/// <param name="maxWait">How long a thread stays where the run is not over by then.</param>
internal sealed class ThreadExits(TimeSpan maxWait)
{
    private readonly object _gate = new();
    private bool _isOpen;   // under _gate

    /// <summary>On a thread that has nothing left to do.</summary>
    public void Wait() => LastResort.DespiteInterrupts(() =>
    {
        lock (_gate)
        {
            if (!_isOpen)
                Monitor.Wait(_gate, maxWait);
            Monitor.Pulse(_gate);
        }
    });

    /// <summary>The run is over.</summary>
    public void Open()
    {
        lock (_gate)
        {
            _isOpen = true;
            Monitor.Pulse(_gate);
        }
    }
}
