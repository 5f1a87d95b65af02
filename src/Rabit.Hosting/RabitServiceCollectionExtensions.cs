using System;
using System.Linq;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.DependencyInjection.Extensions;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;
using Microsoft.Extensions.Options;

namespace Rabit.Hosting;

/// <summary>Adds reactors to a host.</summary>
public static class RabitServiceCollectionExtensions
{
    /// <summary>The name of the reactor where none is given; its settings are in the section "Rabit".</summary>
    public const string DefaultName = "rabit";

    /// <summary>Adds the one reactor of a host, or more to it. Its settings are in the section "Rabit".</summary>
    /// <param name="services">Of the host.</param>
    /// <param name="configure">Adds the managers; called at once.</param>
    public static IServiceCollection AddRabit(this IServiceCollection services, Action<RabitBuilder> configure)
        => services.AddRabit(DefaultName, configure);

    /// <summary>
    /// Adds one of several reactors of a host, or more to it. They start in the order in which they were added, and
    /// stop at the same time. Its settings are in the section "Rabit:NAME".
    /// </summary>
    /// <param name="services">Of the host.</param>
    /// <param name="name">In the log, the meter, the health check and the configuration.</param>
    /// <param name="configure">Adds the managers; called at once.</param>
    /// <exception cref="ArgumentException">The name is empty or has a colon in it.</exception>
    public static IServiceCollection AddRabit(
        this IServiceCollection services, string name, Action<RabitBuilder> configure)
    {
        _ = services ?? throw new ArgumentNullException(nameof(services));
        _ = configure ?? throw new ArgumentNullException(nameof(configure));
        if (string.IsNullOrWhiteSpace(name) || name.Any(c => c == ':'))
            throw new ArgumentException($"A reactor needs a name without a colon, not '{name}'.", nameof(name));

        services.AddRabitServices();
        configure(new RabitBuilder(services, Registration(services, name)));
        return services;
    }

    internal static void AddRabitServices(this IServiceCollection services)
    {
        services.TryAddSingleton(p => new HostedReactors(p.GetServices<ReactorRegistration>()));
        services.TryAddSingleton(_ => new ExitCode());
        services.TryAddSingleton(p => new ReactorFactory(
            p, p.GetServices<ReactorRegistration>(), p.GetRequiredService<ILoggerFactory>(),
            p.GetRequiredService<IOptions<HostOptions>>(), p.GetService<IConfiguration>()));
        services.TryAddEnumerable(ServiceDescriptor.Singleton<IHostedService, RabitHostedService>());
    }

    private static ReactorRegistration Registration(IServiceCollection services, string name)
    {
        ReactorRegistration? known = services.Select(s => s.ImplementationInstance).OfType<ReactorRegistration>()
            .FirstOrDefault(r => string.Equals(r.Name, name, StringComparison.Ordinal));
        if (known is not null)
            return known;
        var registration = new ReactorRegistration(name);
        services.AddSingleton(registration);
        return registration;
    }
}
