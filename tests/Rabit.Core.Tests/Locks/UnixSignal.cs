using System;
using System.Runtime.InteropServices;
using Xunit;

namespace Rabit.Core.Tests.Locks;

/// <summary>
/// A Unix signal to one thread, as a debugger, a profiler or Mono's collector sends them: what the thread waits for in
/// the kernel is interrupted.
/// </summary>
internal static class UnixSignal
{
    private const int User2 = 12;   // SIGUSR2: neither runtime uses it

    /// <summary>
    /// Has the process do nothing at the signal. The handler is a function of libc, since no managed code may run
    /// there, and without SA_RESTART, by which the kernel would begin interrupted calls again.
    /// </summary>
    public static void Install()
    {
        IntPtr nothing = dlsym(IntPtr.Zero, "abs");
        Assert.NotEqual(IntPtr.Zero, nothing);
        signal(User2, nothing);
        Assert.Equal(0, siginterrupt(User2, 1));
    }

    /// <param name="thread">The kernel's id of a thread of this process that has not ended.</param>
    public static void SendTo(int thread) => Assert.Equal(0, tgkill(getpid(), thread, User2));

    [DllImport("libc")]
    private static extern IntPtr dlsym(IntPtr library, [MarshalAs(UnmanagedType.LPStr)] string name);

    [DllImport("libc")]
    private static extern IntPtr signal(int number, IntPtr handler);

    [DllImport("libc")]
    private static extern int siginterrupt(int number, int interrupts);

    [DllImport("libc")]
    private static extern int tgkill(int process, int thread, int number);

    [DllImport("libc")]
    private static extern int getpid();
}
