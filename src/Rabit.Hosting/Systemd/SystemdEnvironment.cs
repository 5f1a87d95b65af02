using System;
using System.Globalization;

namespace Rabit.Hosting;

/// <summary>
/// What systemd says in the environment of a service (sd_notify(3), sd_watchdog_enabled(3)). Immutable.
/// </summary>
internal sealed class SystemdEnvironment
{
    public SystemdEnvironment(Func<string, string?> variable, int processId)
    {
        NotifySocket = variable("NOTIFY_SOCKET") is { Length: > 0 } socket ? socket : null;
        string? pid = variable("WATCHDOG_PID");
        bool isOurs = pid is null or "" || pid == processId.ToString(CultureInfo.InvariantCulture);
        if (isOurs
            && long.TryParse(
                variable("WATCHDOG_USEC"), NumberStyles.None, CultureInfo.InvariantCulture, out long microseconds)
            && microseconds > 0 && microseconds < TimeSpan.MaxValue.Ticks / 10)
            WatchdogTimeout = TimeSpan.FromTicks(microseconds * 10);
    }

    /// <summary>Null where no service manager waits for notifications.</summary>
    public string? NotifySocket { get; }

    /// <summary>Null where none is set, or it is meant for another process.</summary>
    public TimeSpan? WatchdogTimeout { get; }
}
