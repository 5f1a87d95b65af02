using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Microsoft.Extensions.Diagnostics.HealthChecks;
using Rabit.Core;
using Rabit.Hosting;
using Rabit.Uav.HealthMonitoring;
using Rabit.Uav.Messages;
using HealthReport = Rabit.Uav.Messages.HealthReport;

namespace Rabit.Uav.Hosting;

/// <summary>The health of the vehicle, from the report of Health Monitoring. Any thread.</summary>
internal sealed class VehicleHealthCheck(HostedReactors reactors) : IHealthCheck
{
    private readonly object _gate = new();
    private MessageSubscriber<HealthReport>? _health;   // under _gate

    public Task<HealthCheckResult> CheckHealthAsync(
        HealthCheckContext context, CancellationToken cancellationToken = default)
    {
        HealthStatus failure = context.Registration.FailureStatus;
        return Task.FromResult(
            FindWhyNone() is { } reason ? new HealthCheckResult(failure, reason) : Judge(Read(), failure));
    }

    private string? FindWhyNone()
    {
        if (reactors.ResultOf(RabitServiceCollectionExtensions.DefaultName) is { } result)
            return "the managers have ended: " + result.StopReason;
        try
        {
            RabitReactor reactor = reactors[RabitServiceCollectionExtensions.DefaultName];
            if (!reactor.IsWired)
                return "the managers have not started";
            return reactor.Any(m => m.Name == HealthManager.ManagerName)
                ? null
                : "Health Monitoring was left out";
        }
        catch (InvalidOperationException e)
        {
            return e.Message;
        }
    }

    private HealthReport Read()
    {
        lock (_gate)
        {
            _health ??= reactors[RabitServiceCollectionExtensions.DefaultName].Workspace
                .Subscribe<HealthReport>(MessageNames.Health);
            _health.Fetch();
            return _health.Value;
        }
    }

    private static HealthCheckResult Judge(in HealthReport report, HealthStatus failure)
    {
        HealthStatus status = report.Level switch
        {
            HealthLevel.Good => HealthStatus.Healthy,
            HealthLevel.Critical => failure,
            _ => HealthStatus.Degraded,
        };
        var data = new Dictionary<string, object>(StringComparer.Ordinal)
        {
            ["level"] = report.Level.ToString(),
            ["reasons"] = ReasonsOf(report.Reasons),
            ["advice"] = report.Advice.ToString(),
            ["sendsHeartbeat"] = report.SendsHeartbeat,
        };
        if (report.AdviceText is { } why)
            data["adviceText"] = why;
        return new HealthCheckResult(
            status, report.Text ?? (report.Level == HealthLevel.Unknown ? "no report yet" : "good"), data: data);
    }

    private static string[] ReasonsOf(HealthReasons reasons)
        => reasons == HealthReasons.None
            ? []
            : reasons.ToString().Split(',').Select(r => r.Trim()).ToArray();
}
