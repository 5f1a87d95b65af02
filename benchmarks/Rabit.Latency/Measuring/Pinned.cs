using System;
using System.Runtime.ExceptionServices;
using System.Threading;
using Rabit.Latency.Native;

namespace Rabit.Latency.Measuring;

/// <summary>Runs something on a thread of its own that is pinned to a CPU, and waits for it.</summary>
internal static class Pinned
{
    public static void Run(int cpu, Action work)
    {
        ExceptionDispatchInfo? failure = null;
        Thread thread = Start(cpu, "measuring", () =>
        {
            try
            {
                work();
            }
            catch (Exception e)
            {
                // It belongs to the caller.
                failure = ExceptionDispatchInfo.Capture(e);
            }
        });
        thread.Join();
        failure?.Throw();
    }

    public static Thread Start(int cpu, string name, Action work)
    {
        var thread = new Thread(() =>
        {
            Cpus.Pin(cpu);
            work();
        })
        {
            Name = name,
            IsBackground = true,
        };
        thread.Start();
        return thread;
    }
}
