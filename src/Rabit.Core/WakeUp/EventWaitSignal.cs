using System;
using System.Threading;
using Rabit.Core.Time;

namespace Rabit.Core.WakeUp;

/// <summary>The portable wait engine: an <see cref="AutoResetEvent"/>. One thread waits, any thread sets.</summary>
internal sealed class EventWaitSignal<TSync>(RunClock clock) : IWaitSignal
    where TSync : struct, ISyncPoints
{
    private static readonly TimeSpan MaxWait = TimeSpan.FromHours(1);

    private readonly AutoResetEvent _event = new(initialState: false);

    public void Set()
    {
        try
        {
            default(TSync).Set(_event);
        }
        catch (ObjectDisposedException)
        {
            // A waker that was held up since it found the sleeper asleep; by now the sleeper has ended, by another
            // wake.
        }
    }

    public void Wait(TimeSpan until)
    {
        TimeSpan timeout = until - clock.Now;
        if (timeout > MaxWait)
            timeout = MaxWait;

        // The event counts in milliseconds: round up, so that a timer is late by less than one and never early.
        long milliseconds = (timeout.Ticks + TimeSpan.TicksPerMillisecond - 1) / TimeSpan.TicksPerMillisecond;
        default(TSync).Wait(_event, (int)Math.Max(0, milliseconds));
    }

    public void Dispose() => _event.Dispose();
}
