using System;
using System.Collections.Generic;
using System.Linq;
using Microsoft.Extensions.DependencyInjection;
using Microsoft.Extensions.Options;
using Rabit.Core;

namespace Rabit.Uav.Hosting;

/// <summary>What a companion computer of a host is made of. Used by one thread, before the host is built.</summary>
public sealed class RabitUavBuilder
{
    private readonly List<(string Name, Func<IServiceProvider, RabitManager> Create)> _managers = [];
    private readonly List<Action<IServiceProvider, RabitReactor>> _setups = [];

    internal RabitUavBuilder(IServiceCollection services) => Services = services;

    /// <summary>The services of the host: what managers need is added here.</summary>
    public IServiceCollection Services { get; }

    /// <summary>
    /// Adds a manager of the user, made by the container when the host starts; as
    /// <see cref="UavOptions.OtherManagers"/>.
    /// </summary>
    /// <typeparam name="TManager">With one public constructor, which takes services.</typeparam>
    public RabitUavBuilder AddManager<TManager>()
        where TManager : RabitManager
    {
        Services.AddSingleton<TManager>();
        return Add(typeof(TManager).Name, p => p.GetRequiredService<TManager>());
    }

    /// <summary>Adds a manager that a function returns when the host starts. The host does not dispose it.</summary>
    /// <param name="create">Called once, on the thread that starts the host.</param>
    public RabitUavBuilder AddManager(Func<IServiceProvider, RabitManager> create)
        => Add(
            FormattableString.Invariant($"manager {_managers.Count + 1}"),
            create ?? throw new ArgumentNullException(nameof(create)));

    /// <summary>
    /// Leaves out managers of ours, beside those that the setting <c>Uav:Without</c> names; what is then missing is
    /// named by the check of the wiring, until managers that are added take that part.
    /// </summary>
    /// <param name="managers">One or more.</param>
    public RabitUavBuilder LeaveOut(UavManagers managers) => Configure((_, options) => options.Without |= managers);

    /// <summary>Puts a manager of the user in the place of one of ours.</summary>
    /// <typeparam name="TManager">Made by the container; takes the part of the one that is left out.</typeparam>
    /// <param name="manager">The one that is left out.</param>
    public RabitUavBuilder Replace<TManager>(UavManagers manager)
        where TManager : RabitManager
        => LeaveOut(manager).AddManager<TManager>();

    /// <summary>
    /// Sets what no configuration can hold, as a camera of one's own, a detector or links that are open already. It
    /// comes after the configuration and counts more.
    /// </summary>
    /// <param name="configure">Called when the host starts.</param>
    public RabitUavBuilder Configure(Action<IServiceProvider, UavOptions> configure)
    {
        _ = configure ?? throw new ArgumentNullException(nameof(configure));
        Services.AddSingleton<IConfigureOptions<UavOptions>>(
            p => new ConfigureNamedOptions<UavOptions, IServiceProvider>(
                Options.DefaultName, p, (options, services) => configure(services, options)));
        return this;
    }

    /// <summary>
    /// Lets code outside managers see the reactor: a live page, diagnostics, endpoints of a controller
    /// (<see cref="Rabit.Hosting.RabitBuilder.Setup"/>).
    /// </summary>
    /// <param name="setup">Called when the host starts, after the managers were added and before the wiring.</param>
    public RabitUavBuilder Setup(Action<IServiceProvider, RabitReactor> setup)
    {
        _setups.Add(setup ?? throw new ArgumentNullException(nameof(setup)));
        return this;
    }

    internal void RunSetups(IServiceProvider services, RabitReactor reactor)
        => _setups.ForEach(setup => setup(services, reactor));

    /// <summary>Makes the managers of the user.</summary>
    /// <exception cref="OptionsValidationException">Some cannot be made; all of them are named.</exception>
    internal IReadOnlyList<RabitManager> MakeManagers(IServiceProvider services)
    {
        var made = new List<RabitManager>();
        var faults = new List<string>();
        foreach ((string name, Func<IServiceProvider, RabitManager> create) in _managers)
        {
            try
            {
                made.Add(create(services));
            }
            catch (Exception e)
            {
                // Reported with all others.
                faults.Add($"{name} cannot be made: {e.Message}");
            }
        }

        return faults.Count == 0
            ? made
            : throw new OptionsValidationException(UavConfiguration.Section, typeof(UavOptions), faults);
    }

    private RabitUavBuilder Add(string name, Func<IServiceProvider, RabitManager> create)
    {
        _managers.Add((name, create));
        return this;
    }
}
