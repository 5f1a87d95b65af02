using System;
using System.Diagnostics.Tracing;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;

namespace UavService;

/// <summary>
/// Logs that metrics do not reach their collector: OpenTelemetry says so to event listeners only. Any thread.
/// </summary>
internal sealed partial class MetricsFaults(ILogger<MetricsFaults> logger) : EventListener, IHostedService
{
    private const long MillisecondsBetween = 60_000;

    private long _next;

    public Task StartAsync(CancellationToken cancellationToken) => Task.CompletedTask;

    public Task StopAsync(CancellationToken cancellationToken) => Task.CompletedTask;

    // Called by the base constructor too, for sources that are there already: uses no field.
    protected override void OnEventSourceCreated(EventSource eventSource)
    {
        if (eventSource.Name.StartsWith("OpenTelemetry", StringComparison.Ordinal))
            EnableEvents(eventSource, EventLevel.Error);
    }

    // The first, and then one a minute.
    protected override void OnEventWritten(EventWrittenEventArgs eventData)
    {
        long now = Environment.TickCount64, next = Interlocked.Read(ref _next);
        if (now < next || Interlocked.CompareExchange(ref _next, now + MillisecondsBetween, next) != next)
            return;
        string text = string.Join("; ", eventData.Payload?.Select(FirstLine) ?? []);
        NotSent(logger, eventData.EventName, text);
    }

    private static string FirstLine(object? value) => $"{value}".Split('\n')[0].TrimEnd();

    [LoggerMessage(1, LogLevel.Warning, "metrics are not sent ({Event}): {Text}")]
    private static partial void NotSent(ILogger logger, string? @event, string text);
}
