using System;
using System.Threading;
using Rabit.Latency.Native;

namespace Rabit.Latency.Throughput;

/// <summary>
/// One transfer: senders and a receiver that start together, flat out, and yield where the queue is full or empty.
/// </summary>
/// <param name="senders">How many threads send.</param>
/// <param name="messages">How many messages they send together.</param>
/// <param name="inBatches">Whether the ends take several values at a time.</param>
/// <param name="startsReceiver">Whether the receiver arrives at the start; one that sleeps is woken instead.</param>
internal sealed class Flow(int senders, int messages, bool inBatches = false, bool startsReceiver = true)
{
    public const int BatchSize = 64;
    private const int TriesBeforeYield = 64;

    private readonly int _parties = startsReceiver ? senders + 1 : senders;
    private int _ready;   // those that have arrived at the start
    private long _start;  // written by the last of them
    private long _end;    // written by the receiver

    /// <summary>How many there are together; each sender has its part.</summary>
    public int Messages { get; } = messages / senders * senders;

    public bool InBatches => inBatches;

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

    public void SendBatches<TPush, T>(ref TPush queue)
        where TPush : struct, IPushBatch<T>
    {
        T[] values = new T[BatchSize];
        Begin();
        int left = Messages / senders;
        int tries = 0;
        while (left > 0)
        {
            int pushed = queue.PushFrom(values.AsSpan(0, Math.Min(left, BatchSize)));
            left -= pushed;
            if (pushed > 0)
                tries = 0;
            else
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

        End();
    }

    public void ReceiveBatches<TPop, T>(ref TPop queue)
        where TPop : struct, IPopBatch<T>
    {
        T[] values = new T[BatchSize];
        var sink = new Sink<T>();
        Begin();
        int left = Messages;
        int tries = 0;
        while (left > 0)
        {
            int popped = queue.PopInto(values);
            for (int i = 0; i < popped; i++)
                sink.Take(values[i]);
            left -= popped;
            if (popped > 0)
                tries = 0;
            else
                Rest(ref tries);
        }

        End();
    }

    /// <summary>As <see cref="Receive"/>, for a thread that sleeps while the queue is empty.</summary>
    public void ReceiveWaiting<TPop, T>(ref TPop queue)
        where TPop : struct, IPopWaiting<T>
    {
        int count = Messages;
        var sink = new Sink<T>();
        for (int i = 0; i < count; i++)
            sink.Take(queue.Pop());
        End();
    }

    /// <summary>Called by the receiver when it has the last message.</summary>
    public void End() => Interlocked.Exchange(ref _end, MonotonicClock.Now);

    private void Begin()
    {
        if (Interlocked.Increment(ref _ready) == _parties)
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
