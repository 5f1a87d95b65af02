using Microsoft.Extensions.Logging;

namespace Rabit.Hosting;

/// <summary>What goes wrong with the notifications; the ids are those of <see cref="RabitEventIds"/>.</summary>
internal static partial class SystemdLog
{
    [LoggerMessage(12, LogLevel.Warning, "systemd cannot be notified at {Socket}: {Reason}")]
    public static partial void CannotNotify(ILogger logger, string socket, string reason);
}
