using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Rabit.Latency.Native;

/// <summary>
/// The CPUs that this process may use, and the calling thread's place on them. Threads inherit the place of who starts
/// them.
/// </summary>
internal static unsafe class Cpus
{
    private const int Words = 16;   // 1024 CPUs

    /// <summary>Asked once, before anything is pinned.</summary>
    public static IReadOnlyList<int> Allowed { get; } = Find();

    /// <summary>Where one CPU is enough: the last, since the first has most of the interrupts.</summary>
    public static int One => Allowed[Allowed.Count - 1];

    /// <summary>The second of two; the same where there is only one.</summary>
    public static int Other => Allowed[Math.Max(0, Allowed.Count - 2)];

    public static void Pin(int cpu)
    {
        ulong* set = stackalloc ulong[Words];
        for (int i = 0; i < Words; i++)
            set[i] = 0;
        set[cpu / 64] = 1UL << (cpu % 64);
        if (LinuxCalls.sched_setaffinity(0, new UIntPtr(Words * sizeof(ulong)), set) != 0)
            throw new InvalidOperationException(
                $"A thread cannot be pinned to CPU {cpu}: error {Marshal.GetLastWin32Error()}.");
    }

    private static List<int> Find()
    {
        ulong* set = stackalloc ulong[Words];
        for (int i = 0; i < Words; i++)
            set[i] = 0;
        if (LinuxCalls.sched_getaffinity(0, new UIntPtr(Words * sizeof(ulong)), set) < 0)
            throw new InvalidOperationException($"The CPUs cannot be asked for: error {Marshal.GetLastWin32Error()}.");
        var cpus = new List<int>();
        for (int cpu = 0; cpu < Words * 64; cpu++)
        {
            if ((set[cpu / 64] & (1UL << (cpu % 64))) != 0)
                cpus.Add(cpu);
        }

        return cpus;
    }
}
