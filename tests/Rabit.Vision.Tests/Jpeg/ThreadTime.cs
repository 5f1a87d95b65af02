using System;
using System.IO;
using System.Runtime.InteropServices;

namespace Rabit.Vision.Tests.Jpeg;

/// <summary>The processor time of a thread, which other processes and threads do not take part in.</summary>
internal static class ThreadTime
{
    private const int OfThisThread = 3;   // CLOCK_THREAD_CPUTIME_ID of Linux

    private static readonly bool IsThere = Directory.Exists("/proc/self");

    /// <summary>Of this thread so far; always 0 where the system is another one.</summary>
    public static TimeSpan SoFar
        => IsThere && GetTime(OfThisThread, out Time time) == 0
            ? TimeSpan.FromTicks(((long)time.Seconds * TimeSpan.TicksPerSecond) + ((long)time.Nanoseconds / 100))
            : TimeSpan.Zero;

    [DllImport("libc", EntryPoint = "clock_gettime")]
    private static extern int GetTime(int clock, out Time time);

    private struct Time
    {
#pragma warning disable CS0649 // written by the system
        public IntPtr Seconds;
        public IntPtr Nanoseconds;
#pragma warning restore CS0649
    }
}
