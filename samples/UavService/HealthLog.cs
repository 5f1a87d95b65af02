using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Microsoft.Extensions.Diagnostics.HealthChecks;
using Microsoft.Extensions.Logging;

namespace UavService;

/// <summary>Logs each health check when its status changes. One thread at a time.</summary>
internal sealed partial class HealthLog(ILogger<HealthLog> logger) : IHealthCheckPublisher
{
    private readonly Dictionary<string, HealthStatus> _last = [];

    public Task PublishAsync(HealthReport report, CancellationToken cancellationToken)
    {
        foreach ((string name, HealthReportEntry entry) in report.Entries)
        {
            if (_last.TryGetValue(name, out HealthStatus last) && last == entry.Status)
                continue;
            _last[name] = entry.Status;
            LogLevel level = entry.Status == HealthStatus.Healthy ? LogLevel.Information : LogLevel.Warning;
            Changed(logger, level, name, entry.Status, entry.Description);
        }

        return Task.CompletedTask;
    }

    [LoggerMessage(EventId = 1, Message = "{Check} is {Status}: {Description}")]
    private static partial void Changed(
        ILogger logger, LogLevel level, string check, HealthStatus status, string? description);
}
