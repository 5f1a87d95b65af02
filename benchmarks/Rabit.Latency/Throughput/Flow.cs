using System.Threading;
using Rabit.Latency.Native;

namespace Rabit.Latency.Throughput;

/// <summary>
/// One transfer: senders and a receiver that start together, flat out, and yield where the queue is full or empty.
/// </summary>
internal sealed class Flow(int senders, int messages)
{
    private const int TriesBeforeYield = 64;

    private int _ready;   // those that have arrived at the start
    private long _start;  // written by the last of them
    private long _end;    // written by the receiver

    /// <summary>How many there are together; each sender has its part.</summary>
    public int Messages { get; } = messages / senders * senders;

    public double MillionPerSecond => Messages * 1e3 / (Interlocked.Read(ref _end) - Interlocked.Read(ref _start));

    public void Send<TPush, T>(ref TPush queue, T value)
        where TPush : struct, IPush<T>
    {
        Begin();
        int count = Messages / senders;
        for (int i = 0; i < count; i++)
        {
            int tries = 0;
            while (!queue.TryPush(value))
                Rest(ref tries);
        }
    }

    public void Receive<TPop, T>(ref TPop queue)
        where TPop : struct, IPop<T>
    {
        Begin();
        int count = Messages;
        var sink = new Sink<T>();
        for (int i = 0; i < count; i++)
        {
            int tries = 0;
            T value;
            while (!queue.TryPop(out value))
                Rest(ref tries);
            sink.Take(value);
        }

        Interlocked.Exchange(ref _end, MonotonicClock.Now);
    }

    private void Begin()
    {
        if (Interlocked.Increment(ref _ready) == senders + 1)
            Interlocked.Exchange(ref _start, MonotonicClock.Now);
        while (Interlocked.Read(ref _start) == 0)
            Thread.Yield();
    }

    private static void Rest(ref int tries)
    {
        if (++tries < TriesBeforeYield)
            Thread.SpinWait(1);
        else
            Thread.Yield();
    }
}
