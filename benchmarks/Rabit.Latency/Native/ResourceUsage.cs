using System;
using System.Runtime.InteropServices;

namespace Rabit.Latency.Native;

/// <summary>getrusage: what the kernel has counted for the children that have ended.</summary>
internal static unsafe class ResourceUsage
{
    private const int Children = -1;   // RUSAGE_CHILDREN
    private const int Words = 18;      // struct rusage: two times of two words each, and 14 counters

    /// <summary>Processor time of all children that have ended, user and kernel, in microseconds.</summary>
    public static long OfEndedChildren()
    {
        nint* usage = stackalloc nint[Words];
        if (getrusage(Children, usage) != 0)
            throw new InvalidOperationException($"getrusage failed: error {Marshal.GetLastWin32Error()}.");
        return (((long)usage[0] + usage[2]) * 1_000_000) + usage[1] + usage[3];
    }

    [DllImport("libc", SetLastError = true)]
    private static extern int getrusage(int who, nint* usage);
}
