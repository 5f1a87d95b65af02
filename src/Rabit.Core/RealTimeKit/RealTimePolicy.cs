namespace Rabit.Core;

/// <summary>How the kernel shares a CPU among threads of one real-time priority (man 7 sched).</summary>
public enum RealTimePolicy
{
    /// <summary>SCHED_FIFO: the thread runs until it sleeps or one of a higher priority wants the CPU.</summary>
    Fifo,

    /// <summary>SCHED_RR: as FIFO, but time-sliced with others of its priority.</summary>
    RoundRobin,
}
