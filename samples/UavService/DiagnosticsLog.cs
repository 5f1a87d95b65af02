using Microsoft.Extensions.Logging;

namespace UavService;

/// <summary>That nothing can look into the service; it runs all the same.</summary>
internal static partial class DiagnosticsLog
{
    [LoggerMessage(20, LogLevel.Warning, "{Fault}")]
    public static partial void NotOpened(ILogger logger, string fault);
}
