using System;
using System.Runtime.InteropServices;

namespace Rabit.Core;

/// <summary>
/// The futex calls of the Linux kernel (man 2 futex), through syscall(2), which libc exports for every architecture; it has no function
/// for futex itself.
/// </summary>
/// <remarks>The call that waits never suppresses the transition of the garbage collector: a collection would wait for the sleeper.</remarks>
internal static unsafe class Futex
{
    private const int WakePrivate = 1 | 128;              // FUTEX_WAKE | FUTEX_PRIVATE_FLAG
    private const int WaitUntilPrivate = 9 | 128;         // FUTEX_WAIT_BITSET | FUTEX_PRIVATE_FLAG: an absolute time of CLOCK_MONOTONIC
    private const int AnyBit = -1;                        // FUTEX_BITSET_MATCH_ANY
    private const int ClockMonotonic = 1;
    private const int Interrupted = 4;                    // EINTR
    private const int TimedOut = 110;                     // ETIMEDOUT
    private const int NanosecondsPerTick = 100;
    private const long NanosecondsPerSecond = 1_000_000_000;

    // The number of the call (asm/unistd.h); on 32-bit machines the one whose time has 32-bit seconds, as the C types below have.
    private static readonly IntPtr Call = new(RuntimeInformation.ProcessArchitecture switch
    {
        Architecture.X64 => 202,
        Architecture.Arm64 => 98,
        Architecture.Arm or Architecture.X86 => 240,
        _ => -1,
    });

    /// <summary>Whether it works here: asked of the kernel, since a sandbox may forbid it.</summary>
    public static bool IsThere { get; } = Probe();

    /// <summary>Wakes at most one waiter of the word.</summary>
    public static void Wake(int* word) => syscall(Call, word, WakePrivate, 1, null, null, 0);

    /// <summary>
    /// Waits while the word is 0, until it is woken or the time is over. A Unix signal to the thread, as Mono's collector sends, does
    /// not end it: the deadline is absolute, so the wait just goes on.
    /// </summary>
    /// <param name="word">The word.</param>
    /// <param name="atMost">Positive.</param>
    public static void WaitWhileZero(int* word, TimeSpan atMost)
    {
        if (!TryNow(out TimeSpec deadline))
            return;
        long nanoseconds = (long)deadline.Nanoseconds + (atMost.Ticks % TimeSpan.TicksPerSecond * NanosecondsPerTick);
        deadline.Seconds = new IntPtr((long)deadline.Seconds + (atMost.Ticks / TimeSpan.TicksPerSecond) + (nanoseconds / NanosecondsPerSecond));
        deadline.Nanoseconds = new IntPtr(nanoseconds % NanosecondsPerSecond);
        while ((long)syscall(Call, word, WaitUntilPrivate, 0, &deadline, null, AnyBit) == -1 && Marshal.GetLastWin32Error() == Interrupted)
        {
            // The kernel compares the word again, so a wake that came with the signal is not missed.
        }
    }

    private static bool TryNow(out TimeSpec now)
    {
        now = default;
        fixed (TimeSpec* into = &now)
            return clock_gettime(ClockMonotonic, into) == 0;
    }

    // A wait whose time is over already must say so; anything else means that the call is not there or not allowed.
    private static bool Probe()
    {
        if ((long)Call < 0 || !OperatingSystem.IsLinux())
            return false;
        try
        {
            int word = 0;
            var past = default(TimeSpec);
            return TryNow(out _)
                && (long)syscall(Call, &word, WaitUntilPrivate, 0, &past, null, AnyBit) == -1
                && Marshal.GetLastWin32Error() == TimedOut;
        }
        catch (Exception e) when (e is DllNotFoundException or EntryPointNotFoundException)
        {
            return false;
        }
    }

    [DllImport("libc", SetLastError = true)]
    private static extern IntPtr syscall(IntPtr number, int* word, IntPtr operation, IntPtr value, TimeSpec* time, int* secondWord, IntPtr value3);

    private static IntPtr syscall(IntPtr number, int* word, int operation, int value, TimeSpec* time, int* secondWord, int value3)
        => syscall(number, word, new IntPtr(operation), new IntPtr(value), time, secondWord, new IntPtr(value3));

    [DllImport("libc", SetLastError = true)]
    private static extern int clock_gettime(int clock, TimeSpec* time);

    // struct timespec: both members are as long as a pointer, on all three architectures.
    [StructLayout(LayoutKind.Sequential)]
    private struct TimeSpec
    {
        public IntPtr Seconds;
        public IntPtr Nanoseconds;
    }
}
