using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;

namespace Rabit.Core.RealTimeKit;

/// <summary>The calling thread's settings on Linux: x64, arm64 and arm, glibc and musl.</summary>
/// <remarks>
/// The scheduler is set through syscall(2): musl's sched_setscheduler refuses always (its pthreads and POSIX's
/// processes disagree).
/// </remarks>
internal sealed unsafe class LinuxThreadControl : IThreadControl
{
    private const int SetTimerSlackOption = 29;        // PR_SET_TIMERSLACK
    private const int LockCurrentAndFuture = 1 | 2;    // MCL_CURRENT | MCL_FUTURE
    // MCL_ONFAULT: not the hundreds of gigabytes that the collector reserves and never touches
    private const int LockOnFault = 4;
    // SCHED_RESET_ON_FORK: threads that this one starts, the runtime's own too, are ordinary ones
    private const int ResetOnFork = 0x40000000;
    private const int WordsOfCpus = 16;                // 1024 CPUs
    private const int BitsPerWord = 64;
    private const string ThrottleFile = "/proc/sys/kernel/sched_rt_runtime_us";

    // The number of sched_setscheduler (asm/unistd.h).
    private static readonly long SetScheduler = RuntimeInformation.ProcessArchitecture switch
    {
        Architecture.X64 => 144,
        Architecture.Arm64 => 119,
        Architecture.Arm or Architecture.X86 => 156,
        _ => -1,
    };

    public IReadOnlyList<int> Cpus
    {
        get
        {
            ulong* set = stackalloc ulong[WordsOfCpus];
            Clear(set);
            var cpus = new List<int>();
            if (sched_getaffinity(0, Length, set) >= 0)
            {
                // Every thread asks for its own as it starts.
                for (int word = 0; word < WordsOfCpus; word++)
                {
                    int cpu = word * BitsPerWord;
                    for (ulong left = set[word]; left != 0; left >>= 1, cpu++)
                    {
                        if ((left & 1) != 0)
                            cpus.Add(cpu);
                    }
                }
            }

            return cpus;
        }
    }

    public bool ThrottlesRealTime
    {
        get
        {
            try
            {
                return File.ReadAllText(ThrottleFile).Trim() != "-1";
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                // A sandbox without it: the careful answer.
                return false;
            }
        }
    }

    private static UIntPtr Length => new(WordsOfCpus * sizeof(ulong));

    public int SetPriority(RealTimePolicy policy, int priority)
    {
        if (SetScheduler < 0)
            return SystemErrors.NoSuchCall;
        int parameter = priority;   // struct sched_param has this one member
        var number = new IntPtr((policy == RealTimePolicy.Fifo ? 1 : 2) | ResetOnFork);   // SCHED_FIFO, SCHED_RR
        return ErrorOf((long)syscall(new IntPtr(SetScheduler), IntPtr.Zero, number, &parameter));
    }

    public int SetCpus(IReadOnlyList<int> cpus)
    {
        ulong* set = stackalloc ulong[WordsOfCpus];
        Clear(set);
        foreach (int cpu in cpus)
            set[cpu / BitsPerWord] |= 1UL << (cpu % BitsPerWord);
        return ErrorOf(sched_setaffinity(0, Length, set));
    }

    public int SetTimerSlack(long nanoseconds)
        => ErrorOf(
            prctl(SetTimerSlackOption, new UIntPtr((ulong)nanoseconds), UIntPtr.Zero, UIntPtr.Zero, UIntPtr.Zero));

    public int LockMemory() => ErrorOf(mlockall(LockCurrentAndFuture | LockOnFault));

    private static void Clear(ulong* set)
    {
        for (int i = 0; i < WordsOfCpus; i++)
            set[i] = 0;
    }

    private static int ErrorOf(long result) => result >= 0 ? 0 : Marshal.GetLastWin32Error();

    [DllImport("libc", SetLastError = true)]
    private static extern IntPtr syscall(IntPtr number, IntPtr thread, IntPtr policy, int* parameter);

    [DllImport("libc", SetLastError = true)]
    private static extern int sched_setaffinity(int thread, UIntPtr length, ulong* set);

    [DllImport("libc", SetLastError = true)]
    private static extern int sched_getaffinity(int thread, UIntPtr length, ulong* set);

    [DllImport("libc", SetLastError = true)]
    private static extern int prctl(int option, UIntPtr value, UIntPtr unused3, UIntPtr unused4, UIntPtr unused5);

    [DllImport("libc", SetLastError = true)]
    private static extern int mlockall(int flags);
}
