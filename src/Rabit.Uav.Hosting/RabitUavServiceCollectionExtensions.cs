using System;
using System.Linq;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Options;
using Rabit.Core;
using Rabit.Hosting;

namespace Rabit.Uav.Hosting;

/// <summary>Adds a companion computer to a host.</summary>
public static class RabitUavServiceCollectionExtensions
{
    // Mission Control waits 3 s for the answer of the autopilot.
    private static readonly TimeSpan MaxStopDelay = TimeSpan.FromSeconds(4);

    /// <summary>
    /// Adds the six managers as the reactor "rabit" of a host, with their options from the section "Uav", and
    /// <see cref="UavSystem"/> as a service. Whatever is wrong with the settings ends the start of the host, with all
    /// keys named.
    /// </summary>
    /// <param name="services">Of the host.</param>
    /// <param name="configuration">That of the host: appsettings.json, environment, command line.</param>
    /// <param name="configure">Adds, replaces or leaves out managers; called at once. Null for the six.</param>
    /// <exception cref="InvalidOperationException">It was added before: a host has one companion computer.</exception>
    public static IServiceCollection AddRabitUav(
        this IServiceCollection services, IConfiguration configuration, Action<RabitUavBuilder>? configure = null)
    {
        _ = services ?? throw new ArgumentNullException(nameof(services));
        _ = configuration ?? throw new ArgumentNullException(nameof(configuration));
        if (services.Any(s => s.ServiceType == typeof(UavSystem)))
            throw new InvalidOperationException("The companion computer was added before: a host has one.");

        var setup = new UavOptionsSetup(configuration.GetSection(UavConfiguration.Section));
        services.AddOptions<UavOptions>();
        services.AddSingleton<IConfigureOptions<UavOptions>>(setup);
        services.AddSingleton<IValidateOptions<UavOptions>>(setup);
        var uav = new RabitUavBuilder(services);
        configure?.Invoke(uav);
        services.AddSingleton<IPostConfigureOptions<UavOptions>>(
            p => new PostConfigureOptions<UavOptions>(Options.DefaultName, options => Complete(options, uav, p)));
        services.AddSingleton(p => UavSystem.Open(p.GetRequiredService<IOptions<UavOptions>>().Value));
        services.AddRabit(rabit => rabit
            .Configure(o => o.MaxStopDelay = MaxStopDelay)
            .CreateReactor((p, options) => p.GetRequiredService<UavSystem>().CreateReactor(options))
            .Setup(uav.RunSetups)
            .DescribeStatus(reactor => new VehicleText(reactor).Describe));
        return services;
    }

    // After all who configure it, before the check.
    private static void Complete(UavOptions options, RabitUavBuilder uav, IServiceProvider services)
    {
        options.OtherManagers = options.OtherManagers.Concat(uav.MakeManagers(services)).ToArray();

        // The checklist compares the computer's clock with that of the autopilot.
        TimeProvider clock = options.LinkOptions.Clock;
        options.Preflight.UtcNow ??= clock.GetUtcNow;
    }
}
