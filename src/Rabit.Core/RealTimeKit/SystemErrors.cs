using System.Globalization;

namespace Rabit.Core.RealTimeKit;

/// <summary>
/// The names of the system's errors that a request for real time meets (errno; the same numbers on x64, arm64 and arm).
/// </summary>
internal static class SystemErrors
{
    public const int NotPermitted = 1;
    public const int OutOfMemory = 12;
    public const int Invalid = 22;

    public static string Name(int error) => error switch
    {
        NotPermitted => "EPERM",
        3 => "ESRCH",
        11 => "EAGAIN",
        OutOfMemory => "ENOMEM",
        Invalid => "EINVAL",
        38 => "ENOSYS",
        _ => "error " + error.ToString(CultureInfo.InvariantCulture),
    };
}
