using System;
using System.Globalization;

namespace Rabit.Uav.ImageProcessing.VideoDevices;

/// <summary>Why a video device gives no pictures, in words for people, without its name.</summary>
internal sealed class VideoDeviceException : Exception
{
    public const int Interrupted = 4;     // EINTR
    public const int InputOutput = 5;     // EIO
    public const int TryAgain = 11;       // EAGAIN

    private const int NotPermitted = 1;   // EPERM
    private const int NoEntry = 2;        // ENOENT
    private const int NoAddress = 6;      // ENXIO
    private const int AccessDenied = 13;  // EACCES
    private const int Busy = 16;          // EBUSY
    private const int NoDevice = 19;      // ENODEV
    private const int NotADevice = 25;    // ENOTTY

    public VideoDeviceException(string reason)
        : base(reason)
    {
    }

    /// <param name="error">The error number, as the system has it.</param>
    /// <param name="doing">What was tried.</param>
    public VideoDeviceException(int error, string doing)
        : base(error switch
        {
            NoEntry => "there is no such device",
            AccessDenied or NotPermitted =>
                "permission denied; add the user to the group 'video' (sudo usermod -aG video USER) and log in again",
            Busy => "it is in use by another program",
            NoDevice or NoAddress => "it was unplugged",
            NotADevice => "this is no video device",
            _ => $"{doing} failed: error {error.ToString(CultureInfo.InvariantCulture)} of the operating system",
        })
    {
    }
}
