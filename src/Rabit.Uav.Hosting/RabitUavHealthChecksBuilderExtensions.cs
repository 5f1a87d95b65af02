using System;
using System.Collections.Generic;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Diagnostics.HealthChecks;
using Rabit.Hosting;

namespace Rabit.Uav.Hosting;

/// <summary>Adds the vehicle to the health checks of a host.</summary>
public static class RabitUavHealthChecksBuilderExtensions
{
    /// <summary>
    /// Checks the health of the vehicle, as Health Monitoring reports it: degraded at a warning and while nothing is
    /// known, unhealthy where it is critical or without a report. The data has <c>level</c>, <c>reasons</c> (the names
    /// of <see cref="Messages.HealthReasons"/>), <c>advice</c>, <c>adviceText</c> and <c>sendsHeartbeat</c>.
    /// </summary>
    /// <param name="builder">Of the host.</param>
    /// <param name="name">Of the check.</param>
    /// <param name="failureStatus">Null for unhealthy.</param>
    /// <param name="tags">Of the check.</param>
    public static IHealthChecksBuilder AddRabitUav(
        this IHealthChecksBuilder builder, string name = "vehicle", HealthStatus? failureStatus = null,
        IEnumerable<string>? tags = null)
    {
        _ = builder ?? throw new ArgumentNullException(nameof(builder));

        // One for the life of the host: it keeps its subscription.
        VehicleHealthCheck? check = null;
        return builder.Add(new HealthCheckRegistration(
            name,
            p => check ??= new VehicleHealthCheck(p.GetRequiredService<HostedReactors>()),
            failureStatus,
            tags));
    }
}
