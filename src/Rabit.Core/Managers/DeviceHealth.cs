using System;
using System.Threading;

namespace Rabit.Core.Managers;

/// <summary>How a reader or writer is: written by its thread, read by any.</summary>
internal sealed class DeviceHealth
{
    private int _state;
    private Exception? _fault;
    private long _discarded;

    public DeviceState State
    {
        get => (DeviceState)Volatile.Read(ref _state);
        set => Volatile.Write(ref _state, (int)value);
    }

    public Exception? Fault
    {
        get => Volatile.Read(ref _fault);
        set => Volatile.Write(ref _fault, value);
    }

    public long Discarded => Interlocked.Read(ref _discarded);

    public void AddDiscarded(long count) => Interlocked.Add(ref _discarded, count);
}
