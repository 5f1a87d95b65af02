using System.Globalization;

namespace Rabit.Core.RealTimeKit;

/// <summary>
/// The system's errors that requests for real time and locks meet (errno; the same numbers on x64, arm64 and arm).
/// </summary>
internal static class SystemErrors
{
    public const int NotPermitted = 1;
    public const int NoSuchProcess = 3;
    public const int Interrupted = 4;
    public const int TryAgain = 11;
    public const int OutOfMemory = 12;
    public const int Invalid = 22;
    public const int NoSuchCall = 38;

    public static string Name(int error) => error switch
    {
        NotPermitted => "EPERM",
        NoSuchProcess => "ESRCH",
        Interrupted => "EINTR",
        TryAgain => "EAGAIN",
        OutOfMemory => "ENOMEM",
        Invalid => "EINVAL",
        NoSuchCall => "ENOSYS",
        _ => "error " + error.ToString(CultureInfo.InvariantCulture),
    };
}
