using System;
using System.Runtime.InteropServices;

namespace Rabit.Latency.Native;

/// <summary>What a hand-written forwarder is made of.</summary>
internal static unsafe class EpollCalls
{
    public const int Add = 1;            // EPOLL_CTL_ADD
    public const uint Readable = 1;      // EPOLLIN
    public const int DoNotWait = 0x40;   // MSG_DONTWAIT

    [DllImport("libc")]
    public static extern int epoll_create1(int flags);

    [DllImport("libc")]
    public static extern int epoll_ctl(int epoll, int operation, int file, void* what);

    [DllImport("libc")]
    public static extern int epoll_wait(int epoll, void* events, int count, int milliseconds);

    [DllImport("libc")]
    public static extern IntPtr recv(int file, byte* buffer, UIntPtr length, int flags);

    [DllImport("libc")]
    public static extern IntPtr send(int file, byte* buffer, UIntPtr length, int flags);

    [DllImport("libc")]
    public static extern int close(int file);
}
