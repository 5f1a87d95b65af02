using System.Threading;
using System.Threading.Tasks;
using Microsoft.Extensions.Diagnostics.HealthChecks;

namespace Rabit.Hosting;

/// <summary>The health of one reactor, from the status of its managers. Any thread.</summary>
internal sealed class ReactorHealthCheck(HostedReactors reactors, string name) : IHealthCheck
{
    private readonly object _gate = new();
    private readonly ReactorWatch _watch = new(reactors, name);   // under _gate

    public Task<HealthCheckResult> CheckHealthAsync(
        HealthCheckContext context, CancellationToken cancellationToken = default)
    {
        ReactorLook look;
        lock (_gate)
            look = _watch.Look();
        HealthStatus status = look.Condition switch
        {
            ReactorCondition.Good => HealthStatus.Healthy,
            ReactorCondition.Degraded => HealthStatus.Degraded,
            _ => context.Registration.FailureStatus,
        };
        return Task.FromResult(new HealthCheckResult(status, look.ToString(), data: look.Data));
    }
}
