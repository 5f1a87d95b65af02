using System;
using System.Runtime.InteropServices;
using System.Text;

namespace Rabit.Uav.ImageProcessing.VideoDevices;

/// <summary>
/// The C library, with the numbers of Linux on x64, arm64 and arm, which are the same. One thread: it keeps the memory
/// of its calls.
/// </summary>
internal sealed class LinuxVideoSystem : IVideoSystem
{
    private const int OpenFlags = 0x2 | 0x800 | 0x80000;   // O_RDWR, O_NONBLOCK, O_CLOEXEC
    private const int ReadWrite = 0x3;                      // PROT_READ, PROT_WRITE
    private const int Shared = 0x1;                         // MAP_SHARED
    private const int Monotonic = 1;                        // CLOCK_MONOTONIC
    private const short PollIn = 0x1;
    private const string Library = "libc";

    private readonly IntPtr[] _time = new IntPtr[2];        // struct timespec: two numbers of the machine's width
    private readonly PollEntry[] _poll = new PollEntry[1];

    public int PointerBytes => IntPtr.Size;

    public int Open(string path) => Result(open(Encoding.UTF8.GetBytes(path + "\0"), OpenFlags));

    public int Control(int descriptor, uint request, byte[] argument)
        => Result(ioctl(descriptor, (UIntPtr)request, argument));

    public int Wait(int descriptor, int milliseconds)
    {
        _poll[0] = new PollEntry { Descriptor = descriptor, Events = PollIn };
        return Result(poll(_poll, (UIntPtr)1, milliseconds));
    }

    public IntPtr Map(int descriptor, uint offset, int length)
    {
        IntPtr address = mmap(
            IntPtr.Zero, (UIntPtr)(uint)length, ReadWrite, Shared, descriptor, (IntPtr)unchecked((int)offset));
        return address == (IntPtr)(-1) ? IntPtr.Zero : address;
    }

    public void Unmap(IntPtr address, int length) => _ = munmap(address, (UIntPtr)(uint)length);

    public void Close(int descriptor) => _ = close(descriptor);

    public long MonotonicMicroseconds()
        => clock_gettime(Monotonic, _time) == 0 ? ((long)_time[0] * 1_000_000) + ((long)_time[1] / 1000) : 0;

    private static int Result(int returned) => returned >= 0 ? returned : -Marshal.GetLastWin32Error();

    [DllImport(Library, SetLastError = true)]
    private static extern int open(byte[] path, int flags);

    [DllImport(Library, SetLastError = true)]
    private static extern int ioctl(int descriptor, UIntPtr request, byte[] argument);

    [DllImport(Library, SetLastError = true)]
    private static extern int poll([In, Out] PollEntry[] entries, UIntPtr count, int milliseconds);

    [DllImport(Library, SetLastError = true)]
    private static extern IntPtr mmap(
        IntPtr address, UIntPtr length, int protection, int flags, int descriptor, IntPtr offset);

    [DllImport(Library)]
    private static extern int munmap(IntPtr address, UIntPtr length);

    [DllImport(Library)]
    private static extern int close(int descriptor);

    [DllImport(Library)]
    private static extern int clock_gettime(int clock, [In, Out] IntPtr[] time);

    /// <summary>struct pollfd.</summary>
    [StructLayout(LayoutKind.Sequential)]
    private struct PollEntry
    {
        public int Descriptor;
        public short Events;
        public short Occurred;
    }
}
