using System;
using System.Collections.Generic;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Diagnostics.HealthChecks;

namespace Rabit.Hosting;

/// <summary>Adds reactors to the health checks of a host.</summary>
public static class RabitHealthChecksBuilderExtensions
{
    /// <summary>
    /// Checks a reactor: unhealthy where a manager hangs, is faulted or has stopped, or the reactor does not run;
    /// degraded where a manager is restarted or missed deadlines since the last check. The data has state, runs,
    /// faults, restarts, hangs and missed deadlines of each manager, as <c>heater.state</c>.
    /// </summary>
    /// <param name="builder">Of the host.</param>
    /// <param name="reactor">The name of the reactor, and of the check.</param>
    /// <param name="failureStatus">Null for unhealthy.</param>
    /// <param name="tags">Of the check.</param>
    public static IHealthChecksBuilder AddRabit(
        this IHealthChecksBuilder builder, string reactor = RabitServiceCollectionExtensions.DefaultName,
        HealthStatus? failureStatus = null, IEnumerable<string>? tags = null)
    {
        _ = builder ?? throw new ArgumentNullException(nameof(builder));

        // One for the life of the host: it counts from check to check.
        ReactorHealthCheck? check = null;
        return builder.Add(new HealthCheckRegistration(
            reactor,
            p => check ??= new ReactorHealthCheck(p.GetRequiredService<HostedReactors>(), reactor),
            failureStatus,
            tags));
    }
}
