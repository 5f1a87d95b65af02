using System;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.DependencyInjection.Extensions;
using Microsoft.Extensions.Hosting;

namespace Rabit.Hosting;

/// <summary>Makes a host a service of systemd.</summary>
public static class RabitSystemdExtensions
{
    /// <summary>
    /// Reports to systemd by its notification protocol (<c>Type=notify</c>): READY when every reactor has passed its
    /// start-up barrier, STATUS with what is wrong, WATCHDOG while no manager hangs, STOPPING with the time that the
    /// ordered stop may take. Has no effect where no service manager waits for notifications.
    /// </summary>
    /// <param name="services">Of the host.</param>
    public static IServiceCollection AddRabitSystemd(this IServiceCollection services)
    {
        _ = services ?? throw new ArgumentNullException(nameof(services));
        services.AddRabitServices();
        services.TryAddSingleton(_ => new SystemdEnvironment(
            Environment.GetEnvironmentVariable, ProcessId()));
        services.TryAddEnumerable(ServiceDescriptor.Singleton<IHostedService, SystemdNotifier>());
        return services;
    }

    private static int ProcessId()
    {
        using var process = System.Diagnostics.Process.GetCurrentProcess();
        return process.Id;
    }
}
