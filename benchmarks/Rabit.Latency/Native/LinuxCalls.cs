using System;
using System.Runtime.InteropServices;

namespace Rabit.Latency.Native;

/// <summary>
/// The calls of Linux that the limits are made of; the runner's own, so that a fault of the library's does not hide in
/// both.
/// </summary>
internal static unsafe class LinuxCalls
{
    public const int ClockMonotonic = 1;
    public const int ClockOfProcess = 2;   // CLOCK_PROCESS_CPUTIME_ID: all threads, user and kernel, in nanoseconds
    public const int ClockOfThread = 3;    // CLOCK_THREAD_CPUTIME_ID
    public const int AbsoluteTime = 1;     // TIMER_ABSTIME

    private const int FutexWaitPrivate = 128;
    private const int FutexWakePrivate = 1 | 128;
    private const int FutexWaitUntilPrivate = 9 | 128;   // FUTEX_WAIT_BITSET: an absolute time of CLOCK_MONOTONIC

    private static readonly IntPtr FutexCall = new(RuntimeInformation.ProcessArchitecture switch
    {
        Architecture.X64 => 202,
        Architecture.Arm64 => 98,
        _ => 240,
    });

    public static void FutexWait(int* word, int value)
        => syscall(FutexCall, word, new IntPtr(FutexWaitPrivate), new IntPtr(value), null, null, IntPtr.Zero);

    public static void FutexWaitUntil(int* word, int value, TimeSpec* until)
        => syscall(FutexCall, word, new IntPtr(FutexWaitUntilPrivate), new IntPtr(value), until, null, new IntPtr(-1));

    public static void FutexWake(int* word)
        => syscall(FutexCall, word, new IntPtr(FutexWakePrivate), new IntPtr(1), null, null, IntPtr.Zero);

    [DllImport("libc")]
    public static extern int clock_gettime(int clock, TimeSpec* time);

    [DllImport("libc")]
    public static extern int clock_nanosleep(int clock, int flags, TimeSpec* time, TimeSpec* left);

    [DllImport("libc", SetLastError = true)]
    public static extern int sched_setaffinity(int thread, UIntPtr length, ulong* set);

    [DllImport("libc", SetLastError = true)]
    public static extern int sched_getaffinity(int thread, UIntPtr length, ulong* set);

    [DllImport("libc")]
    private static extern IntPtr syscall(
        IntPtr number, int* word, IntPtr operation, IntPtr value, TimeSpec* time, int* secondWord, IntPtr value3);
}
