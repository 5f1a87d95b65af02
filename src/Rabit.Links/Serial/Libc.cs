using System;
using System.Runtime.InteropServices;

namespace Rabit.Links;

/// <summary>
/// The calls of the C library that a serial line needs, with the numbers of Linux on x64, arm64 and arm (the same on
/// all three). Each call that fails returns -1 and leaves its reason to <see cref="Marshal.GetLastWin32Error"/>.
/// </summary>
internal static unsafe class Libc
{
    public const int ReadWrite = 0x2; // O_RDWR
    public const int NoControllingTerminal = 0x100; // O_NOCTTY
    public const int NonBlocking = 0x800; // O_NONBLOCK, EFD_NONBLOCK
    public const int CloseOnExec = 0x80000; // O_CLOEXEC, EFD_CLOEXEC

    public const short PollIn = 0x1;
    public const short PollOut = 0x4;

    public const int SetNow = 0; // TCSANOW
    public const uint GetTermios2 = 0x802C542A; // TCGETS2
    public const uint SetTermios2 = 0x402C542B; // TCSETS2
    public const uint SetExclusive = 0x540C; // TIOCEXCL

    private const string Library = "libc";

    [DllImport(Library, SetLastError = true)]
    public static extern int open(byte* path, int flags);

    [DllImport(Library, SetLastError = true)]
    public static extern int close(int descriptor);

    [DllImport(Library, SetLastError = true)]
    public static extern nint read(int descriptor, byte* buffer, nuint count);

    [DllImport(Library, SetLastError = true)]
    public static extern nint write(int descriptor, byte* buffer, nuint count);

    [DllImport(Library, SetLastError = true)]
    public static extern int poll(PollEntry* entries, nuint count, int timeoutMilliseconds);

    [DllImport(Library, SetLastError = true)]
    public static extern int eventfd(uint initial, int flags);

    [DllImport(Library, SetLastError = true)]
    public static extern int ioctl(int descriptor, nuint request, byte* argument);

    [DllImport(Library, SetLastError = true)]
    public static extern int tcgetattr(int descriptor, byte* termios);

    [DllImport(Library, SetLastError = true)]
    public static extern int tcsetattr(int descriptor, int when, byte* termios);

    [DllImport(Library)]
    public static extern void cfmakeraw(byte* termios);

    [DllImport(Library, SetLastError = true)]
    public static extern int cfsetspeed(byte* termios, uint speed);

    /// <summary>One descriptor to poll; struct pollfd.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct PollEntry
    {
        public int Descriptor;
        public short Events;
        public short Occurred;
    }
}
