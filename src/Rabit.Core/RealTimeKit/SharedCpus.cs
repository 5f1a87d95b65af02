using System;
using System.Collections.Generic;
using System.Threading;

namespace Rabit.Core.RealTimeKit;

/// <summary>
/// Which CPUs have several threads of a run that may run nowhere else: one that spins there keeps the others from what
/// it waits for. One of a run.
/// </summary>
/// <param name="control">The operating system; null where threads cannot be pinned.</param>
/// <param name="processors">How many the process may use.</param>
internal sealed class SharedCpus(IThreadControl? control, int processors)
{
    private const int MaxCpus = 1024;

    private readonly int[] _threads = new int[MaxCpus];   // written by each thread once, read by those that spin

    /// <summary>For threads of this machine.</summary>
    public static SharedCpus ForThreads()
        => new(OperatingSystem.IsLinux() ? new LinuxThreadControl() : null, Environment.ProcessorCount);

    /// <summary>Called on a thread when its place is settled: after its start-up.</summary>
    public SpinPermit Enter()
    {
        int onlyCpu = FindOnlyCpu();
        if (onlyCpu >= 0)
            Interlocked.Increment(ref _threads[onlyCpu]);
        return new SpinPermit(this, onlyCpu);
    }

    public bool MaySpin(int onlyCpu)
        => processors > 1 && (onlyCpu < 0 || Volatile.Read(ref _threads[onlyCpu]) == 1);

    private int FindOnlyCpu()
    {
        try
        {
            return control?.Cpus is { Count: 1 } own && own[0] < MaxCpus ? own[0] : -1;
        }
        catch (Exception e) when (e is DllNotFoundException or EntryPointNotFoundException)
        {
            // Threads cannot be pinned there either.
            return -1;
        }
    }
}
