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
    {
        var flow = new Flow(senders, messages);
        var threads = new List<Thread>();
        for (int i = 0; i < senders; i++)
        {
            threads.Add(Begin(senders, Cpus.One, () =>
            {
                TEnds own = queue;
                flow.Send<TEnds, T>(ref own, default);
            }));
        }

        threads.Add(Begin(senders, Cpus.Other, () =>
        {
            TEnds own = queue;
            flow.Receive<TEnds, T>(ref own);
        }));
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
