using System;
using System.Runtime.InteropServices;
using Rabit.Core.Time;

namespace Rabit.Core.WakeUp;

/// <summary>
/// The futex calls of the Linux kernel (man 2 futex), through syscall(2), which libc exports for every architecture; it
/// has no function for futex itself.
/// </summary>
/// <remarks>
/// The call that waits never suppresses the transition of the garbage collector: a collection would wait for the
/// sleeper.
/// </remarks>
internal static unsafe class Futex
{
    private const int WakePrivate = 1 | 128;              // FUTEX_WAKE | FUTEX_PRIVATE_FLAG
    // FUTEX_WAIT_BITSET | FUTEX_PRIVATE_FLAG: an absolute time of CLOCK_MONOTONIC
    private const int WaitUntilPrivate = 9 | 128;
    private const int AnyBit = -1;                        // FUTEX_BITSET_MATCH_ANY
    private const int ClockMonotonic = 1;
    private const int TimedOut = 110;                     // ETIMEDOUT
    private const int NanosecondsPerTick = 100;
    private const long NanosecondsPerSecond = 1_000_000_000;

    // Where the run has a clock of its own, which the kernel's may leave behind.
    private static readonly TimeSpan MaxGuess = TimeSpan.FromHours(1);

    // The seconds of a 32-bit machine have 31 bits, 68 years, and begin when it does.
    private static readonly TimeSpan MaxWait = TimeSpan.FromDays(365 * 50);

    // The number of the call (asm/unistd.h); on 32-bit machines the one whose time has 32-bit seconds, as the C types
    // below have.
    private static readonly IntPtr Call = new(RuntimeInformation.ProcessArchitecture switch
    {
        Architecture.X64 => 202,
        Architecture.Arm64 => 98,
        Architecture.Arm or Architecture.X86 => 240,
        _ => -1,
    });

    /// <summary>Whether it works here: asked of the kernel, since a sandbox may forbid it.</summary>
    public static bool IsThere { get; } = Probe();

    // Whether the system's TimeProvider counts CLOCK_MONOTONIC, from its zero on: then deadlines need no look at a
    // clock.
    private static bool SystemClockIsKernels { get; } = IsThere && ProbeSystemClock();

    /// <summary>Wakes at most one waiter of the word.</summary>
    public static void Wake(int* word)
        => syscall(Call, word, new IntPtr(WakePrivate), new IntPtr(1), null, null, IntPtr.Zero);

    /// <summary>
    /// Waits while the word is 0, until it is woken or the time is over. A Unix signal to the thread, as Mono's
    /// collector sends, ends it early, as the caller expects.
    /// </summary>
    /// <param name="word">The word.</param>
    /// <param name="until">
    /// By the clock of the run; where it is over already the kernel may still take the slack of its timers.
    /// </param>
    /// <param name="clock">The clock of the run.</param>
    public static void WaitWhileZero(int* word, TimeSpan until, RunClock clock)
    {
        long nanoseconds = Deadline(until, clock);
        if (nanoseconds == 0)
            return;
        var deadline = new TimeSpec
        {
            Seconds = new IntPtr(nanoseconds / NanosecondsPerSecond),
            Nanoseconds = new IntPtr(nanoseconds % NanosecondsPerSecond),
        };
        syscall(Call, word, new IntPtr(WaitUntilPrivate), IntPtr.Zero, &deadline, null, new IntPtr(AnyBit));
    }

    private static long Deadline(TimeSpan until, RunClock clock)
    {
        if (SystemClockIsKernels && clock.SystemOriginNanoseconds is { } origin)
            return origin + ((until < MaxWait ? until : MaxWait).Ticks * NanosecondsPerTick);
        TimeSpan left = until - clock.Now;
        return left > TimeSpan.Zero ? Now() + ((left < MaxGuess ? left : MaxGuess).Ticks * NanosecondsPerTick) : 0;
    }

    // CLOCK_MONOTONIC; it has no way to fail where the probe has read it.
    private static long Now()
    {
        TimeSpec now;
        _ = clock_gettime(ClockMonotonic, &now);
        return ((long)now.Seconds * NanosecondsPerSecond) + (long)now.Nanoseconds;
    }

    // A wait whose time is over already must say so; anything else means that the call is not there or not allowed.
    private static bool Probe()
    {
        if ((long)Call < 0 || !OperatingSystem.IsLinux())
            return false;
        try
        {
            int word = 0;
            TimeSpec now;
            var past = default(TimeSpec);
            return clock_gettime(ClockMonotonic, &now) == 0
                && (long)SyscallWithError(
                    Call, &word, new IntPtr(WaitUntilPrivate), IntPtr.Zero, &past, null, new IntPtr(AnyBit)) == -1
                && Marshal.GetLastWin32Error() == TimedOut;
        }
        catch (Exception e) when (e is DllNotFoundException or EntryPointNotFoundException)
        {
            return false;
        }
    }

    private static bool ProbeSystemClock()
    {
        if (NanosecondsPerSecond % TimeProvider.System.TimestampFrequency != 0)
            return false;
        long nanosecondsPerCount = NanosecondsPerSecond / TimeProvider.System.TimestampFrequency;
        long before = Now() / nanosecondsPerCount;
        long count = TimeProvider.System.GetTimestamp();
        return before <= count && count <= Now() / nanosecondsPerCount;
    }

    [DllImport("libc")]
    private static extern IntPtr syscall(
        IntPtr number, int* word, IntPtr operation, IntPtr value, TimeSpec* time, int* secondWord, IntPtr value3);

    [DllImport("libc", EntryPoint = "syscall", SetLastError = true)]
    private static extern IntPtr SyscallWithError(
        IntPtr number, int* word, IntPtr operation, IntPtr value, TimeSpec* time, int* secondWord, IntPtr value3);

    [DllImport("libc")]
    private static extern int clock_gettime(int clock, TimeSpec* time);

    // struct timespec: both members are as long as a pointer, on all three architectures.
    [StructLayout(LayoutKind.Sequential)]
    private struct TimeSpec
    {
        public IntPtr Seconds;
        public IntPtr Nanoseconds;
    }
}
