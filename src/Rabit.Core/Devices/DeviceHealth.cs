using System;
using System.Threading;

namespace Rabit.Core.Devices;

/// <summary>How a reader or writer is: written by its thread, read by any.</summary>
internal sealed class DeviceHealth
{
    private int _state;
    private Exception? _fault;
    private long _sinceTicks;
    private long _discarded;
    private long _faults;
    private long _reconnects;

    public DeviceState State => (DeviceState)Volatile.Read(ref _state);

    public TimeSpan Since => new(Interlocked.Read(ref _sinceTicks));

    public Exception? Fault => Volatile.Read(ref _fault);

    public long Faults => Interlocked.Read(ref _faults);

    public long Reconnects => Interlocked.Read(ref _reconnects);

    public long Discarded => Interlocked.Read(ref _discarded);

    public void Enter(DeviceState state, TimeSpan now)
    {
        Interlocked.Exchange(ref _sinceTicks, now.Ticks);
        Volatile.Write(ref _state, (int)state);
    }

    public void AddFault(Exception fault)
    {
        Volatile.Write(ref _fault, fault);
        Interlocked.Increment(ref _faults);
    }

    public void AddReconnect() => Interlocked.Increment(ref _reconnects);

    public void AddDiscarded(long count) => Interlocked.Add(ref _discarded, count);
}
