using System;
using System.Collections.Generic;
using System.Threading;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;

namespace Rabit.Latency.Throughput;

/// <summary>Transfers between threads without Rabit.</summary>
internal static class BaselineFlow
{
    public static double Run<TEnds, T>(TEnds queue, int senders, int messages)
        where TEnds : struct, IPush<T>, IPop<T>
        where T : struct
        => Run(
            new Flow(senders, messages),
            senders,
            flow =>
            {
                TEnds own = queue;
                flow.Send<TEnds, T>(ref own, default);
            },
            flow =>
            {
                TEnds own = queue;
                flow.Receive<TEnds, T>(ref own);
            });

    /// <summary>Several values at a time.</summary>
    public static double RunBatches<TEnds, T>(TEnds queue, int senders, int messages)
        where TEnds : struct, IPushBatch<T>, IPopBatch<T>
        where T : struct
        => Run(
            new Flow(senders, messages, inBatches: true),
            senders,
            flow =>
            {
                TEnds own = queue;
                flow.SendBatches<TEnds, T>(ref own);
            },
            flow =>
            {
                TEnds own = queue;
                flow.ReceiveBatches<TEnds, T>(ref own);
            });

    /// <summary>To a receiver that sleeps while there is nothing.</summary>
    public static double RunWaking<TEnds, T>(TEnds queue, int senders, int messages)
        where TEnds : struct, IPush<T>, IPopWaiting<T>
        where T : struct
        => Run(
            new Flow(senders, messages, startsReceiver: false),
            senders,
            flow =>
            {
                TEnds own = queue;
                flow.Send<TEnds, T>(ref own, default);
            },
            flow =>
            {
                TEnds own = queue;
                flow.ReceiveWaiting<TEnds, T>(ref own);
            });

    private static double Run(Flow flow, int senders, Action<Flow> send, Action<Flow> receive)
    {
        var threads = new List<Thread> { Begin(senders, Cpus.Other, () => receive(flow)) };
        for (int i = 0; i < senders; i++)
            threads.Add(Begin(senders, Cpus.One, () => send(flow)));
        threads.ForEach(t => t.Join());
        return flow.MillionPerSecond;
    }

    // Two threads have a CPU each; more are left to the scheduler.
    private static Thread Begin(int senders, int cpu, Action work)
    {
        if (senders == 1)
            return Pinned.Start(cpu, "flow", work);
        var thread = new Thread(() => work()) { IsBackground = true };
        thread.Start();
        return thread;
    }
}
