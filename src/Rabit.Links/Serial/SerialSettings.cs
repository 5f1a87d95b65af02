using System;
using System.Globalization;
using System.Runtime.InteropServices;

namespace Rabit.Links;

/// <summary>
/// Sets a terminal to raw bytes, 8 data bits, no parity, 1 stop bit, no flow control, a given speed.
/// See termios(3) and ioctl_tty(2).
/// </summary>
internal static unsafe class SerialSettings
{
    // struct termios is 60 bytes with glibc and differs elsewhere; the flags come first everywhere: input, output,
    // control, local.
    private const int TermiosRoom = 256;
    private const int ControlFlags = 2;

    // struct termios2 of the kernel: 4 flag words, 20 bytes, input speed, output speed.
    private const int Termios2Words = 11;
    private const int InputSpeed = 9;
    private const int OutputSpeed = 10;

    private const uint TwoStopBits = 0x40; // CSTOPB
    private const uint EnableReceiver = 0x80; // CREAD
    private const uint IgnoreModemLines = 0x800; // CLOCAL
    private const uint HardwareFlowControl = 0x80000000; // CRTSCTS
    private const uint SpeedMask = 0x100F100F; // CBAUD and CIBAUD
    private const uint OtherSpeed = 0x10001000; // BOTHER, for output and input

    // A UART divides its clock; what it makes of a rate may be off by this much and both sides still understand each
    // other.
    private const double SpeedTolerance = 0.025;

    /// <summary>Sets the terminal. Null, or what is wrong.</summary>
    public static string? Apply(int descriptor, int baudRate)
    {
        byte* termios = stackalloc byte[TermiosRoom];
        if (Libc.tcgetattr(descriptor, termios) < 0) return Fault();
        Libc.cfmakeraw(termios);
        uint* flags = (uint*)termios;
        flags[ControlFlags] = (flags[ControlFlags] | EnableReceiver | IgnoreModemLines)
            & ~(TwoStopBits | HardwareFlowControl);

        bool standard = Libc.cfsetspeed(termios, (uint)baudRate) == 0;
        if (Libc.tcsetattr(descriptor, Libc.SetNow, termios) < 0) return Fault();
        if (!standard && SetOtherSpeed(descriptor, (uint)baudRate) is { } fault) return fault;
        return CheckSpeed(descriptor, baudRate);
    }

    private static string? SetOtherSpeed(int descriptor, uint baudRate)
    {
        uint* termios = stackalloc uint[Termios2Words];
        if (Libc.ioctl(descriptor, Libc.GetTermios2, (byte*)termios) < 0) return RateFault(baudRate);
        termios[ControlFlags] = (termios[ControlFlags] & ~SpeedMask) | OtherSpeed;
        termios[InputSpeed] = baudRate;
        termios[OutputSpeed] = baudRate;
        return Libc.ioctl(descriptor, Libc.SetTermios2, (byte*)termios) < 0 ? RateFault(baudRate) : null;
    }

    // A driver that cannot do a rate keeps another one and reports success.
    private static string? CheckSpeed(int descriptor, int baudRate)
    {
        uint* termios = stackalloc uint[Termios2Words];
        // too old a kernel, or an emulator, to say
        if (Libc.ioctl(descriptor, Libc.GetTermios2, (byte*)termios) < 0) return null;
        uint actual = termios[OutputSpeed];
        if (Math.Abs(actual - (double)baudRate) <= baudRate * SpeedTolerance) return null;
        return $"the device cannot do {Text(baudRate)} baud; it offers {Text(actual)}";
    }

    private static string Fault() => Errno.Describe(Marshal.GetLastWin32Error());

    private static string RateFault(uint baudRate)
    {
        int errno = Marshal.GetLastWin32Error();
        return $"the device cannot do {Text(baudRate)} baud: {Errno.Describe(errno)}";
    }

    private static string Text(long rate) => rate.ToString(CultureInfo.InvariantCulture);
}
