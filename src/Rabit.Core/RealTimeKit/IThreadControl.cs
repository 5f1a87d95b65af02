using System.Collections.Generic;

namespace Rabit.Core.RealTimeKit;

/// <summary>
/// What an operating system can do for the calling thread. Each call gives 0 or the number of the error (errno).
/// </summary>
internal interface IThreadControl
{
    /// <summary>The CPUs on which the calling thread may run now.</summary>
    IReadOnlyList<int> Cpus { get; }

    /// <summary>Whether the kernel keeps a part of every CPU from real-time threads that never sleep.</summary>
    bool ThrottlesRealTime { get; }

    int SetPriority(RealTimePolicy policy, int priority);

    int SetCpus(IReadOnlyList<int> cpus);

    int SetTimerSlack(long nanoseconds);

    /// <summary>For the whole process: pages stay in memory from the moment they are touched.</summary>
    int LockMemory();
}
