using System.Globalization;

namespace Rabit.Links;

/// <summary>The error numbers of Linux that a serial line meets, and how to say them to a user.</summary>
internal static class Errno
{
    public const int NotPermitted = 1; // EPERM
    public const int NoEntry = 2; // ENOENT
    public const int Interrupted = 4; // EINTR
    public const int InputOutput = 5; // EIO
    public const int NoDeviceOrAddress = 6; // ENXIO
    public const int TryAgain = 11; // EAGAIN
    public const int AccessDenied = 13; // EACCES
    public const int Busy = 16; // EBUSY
    public const int NoDevice = 19; // ENODEV
    public const int NotDirectory = 20; // ENOTDIR
    public const int IsDirectory = 21; // EISDIR
    public const int Invalid = 22; // EINVAL
    public const int TooManyFilesOfSystem = 23; // ENFILE
    public const int TooManyFiles = 24; // EMFILE
    public const int NotATerminal = 25; // ENOTTY
    public const int NotImplemented = 38; // ENOSYS
    public const int NotSupported = 95; // EOPNOTSUPP

    /// <summary>What the kernel answers once the device is gone.</summary>
    public static bool IsUnplugged(int errno) => errno is InputOutput or NoDeviceOrAddress or NoDevice;

    /// <summary>Whether a device that could not be opened may be there, or free, later.</summary>
    public static bool MayPass(int errno)
        => errno is NoEntry or NotDirectory or Busy or TryAgain || IsUnplugged(errno);

    public static string Describe(int errno) => errno switch
    {
        NoEntry or NotDirectory => "there is no such device",
        AccessDenied or NotPermitted =>
            "permission denied; add the user to the group 'dialout' (sudo usermod -aG dialout USER) and log in again",
        Busy => "the device is in use by another program",
        NotATerminal or IsDirectory => "this is not a serial device",
        NoDevice or NoDeviceOrAddress or InputOutput => "the device does not answer (unplugged?)",
        Invalid => "the device or its driver refuses the setting (EINVAL)",
        TooManyFiles or TooManyFilesOfSystem => "too many files are open (EMFILE or ENFILE)",
        NotImplemented or NotSupported =>
            "the kernel or its emulation lacks a call that this needs (ENOSYS); emulators such as qemu-user do not "
                + "know custom baud rates",
        _ => $"error {errno.ToString(CultureInfo.InvariantCulture)} of the operating system (errno)",
    };
}
