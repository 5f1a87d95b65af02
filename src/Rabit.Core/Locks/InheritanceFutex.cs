using System;
using System.Runtime.InteropServices;
using Rabit.Core.RealTimeKit;

namespace Rabit.Core.Locks;

/// <summary>
/// The futex calls of the Linux kernel for locks with priority inheritance (man 2 futex), and what goes with them: the
/// kernel's ids of threads.
/// </summary>
/// <remarks>
/// A wait never suppresses the transition of the garbage collector, which would wait for the sleeper. The kernel begins
/// an interrupted one again by itself.
/// </remarks>
internal static unsafe class InheritanceFutex
{
    private const int LockPrivate = 6 | 128;     // FUTEX_LOCK_PI | FUTEX_PRIVATE_FLAG
    private const int UnlockPrivate = 7 | 128;   // FUTEX_UNLOCK_PI | FUTEX_PRIVATE_FLAG

    // The numbers of the calls (asm/unistd.h): futex, gettid, and tgkill with signal 0, which only asks.
    private static readonly (int Futex, int ThreadId, int SignalThread) Calls =
        RuntimeInformation.ProcessArchitecture switch
        {
            Architecture.X64 => (202, 186, 234),
            Architecture.Arm64 => (98, 178, 131),
            Architecture.Arm => (240, 224, 268),
            Architecture.X86 => (240, 224, 270),
            _ => (-1, -1, -1),
        };

    // Written and read by the thread itself: its id, which does not change; 0 before it was asked for. To ask each time
    // would cost more than the lock.
    [ThreadStatic]
    private static int _threadId;

    /// <summary>
    /// Whether it works here: asked of the kernel, since it may be built without, and a sandbox may forbid it.
    /// </summary>
    public static bool IsThere { get; } = Probe();

    /// <summary>The kernel's id of the calling thread, which never is 0.</summary>
    public static int ThreadId => _threadId != 0 ? _threadId : AskForThreadId();

    /// <summary>
    /// Waits for the lock; its holder has at least this thread's priority meanwhile. Then the word is this thread's id,
    /// and perhaps bits of the kernel.
    /// </summary>
    /// <returns>0, or the error.</returns>
    public static int Lock(int* word) => Call(word, LockPrivate);

    /// <summary>Hands the lock to the first of those who wait; frees it where there are none.</summary>
    /// <returns>0, or the error.</returns>
    public static int Unlock(int* word) => Call(word, UnlockPrivate);

    /// <summary>Whether a thread of this process has not ended yet.</summary>
    public static bool IsAlive(int threadId)
        => (long)syscall(new IntPtr(Calls.SignalThread), new IntPtr(getpid()), new IntPtr(threadId), IntPtr.Zero) == 0
            || Marshal.GetLastWin32Error() != SystemErrors.NoSuchProcess;

    private static int Call(int* word, int operation)
        => (long)syscall(
            new IntPtr(Calls.Futex), new IntPtr(word), new IntPtr(operation), IntPtr.Zero, IntPtr.Zero, IntPtr.Zero,
            IntPtr.Zero) == 0
                ? 0
                : Marshal.GetLastWin32Error();

    private static int AskForThreadId()
        => _threadId = (int)syscall(new IntPtr(Calls.ThreadId), IntPtr.Zero, IntPtr.Zero, IntPtr.Zero);

    private static bool Probe()
    {
        if (Calls.Futex < 0 || !OperatingSystem.IsLinux())
            return false;
        try
        {
            int word = 0;
            return Lock(&word) == 0 && word == ThreadId && Unlock(&word) == 0 && word == 0;
        }
        catch (Exception e) when (e is DllNotFoundException or EntryPointNotFoundException)
        {
            return false;
        }
    }

    [DllImport("libc")]
    private static extern int getpid();

    [DllImport("libc", SetLastError = true)]
    private static extern IntPtr syscall(IntPtr number, IntPtr argument1, IntPtr argument2, IntPtr argument3);

    [DllImport("libc", SetLastError = true)]
    private static extern IntPtr syscall(
        IntPtr number, IntPtr word, IntPtr operation, IntPtr value, IntPtr time, IntPtr secondWord, IntPtr value3);
}
