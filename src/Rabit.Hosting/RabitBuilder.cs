using System;
using System.Diagnostics.CodeAnalysis;
using Microsoft.Extensions.DependencyInjection;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>What belongs to one reactor of a host. Used by one thread, before the host is built.</summary>
public sealed class RabitBuilder
{
    private readonly ReactorRegistration _registration;

    internal RabitBuilder(IServiceCollection services, ReactorRegistration registration)
        => (Services, _registration) = (services, registration);

    /// <summary>The services of the host: what managers need is added here.</summary>
    public IServiceCollection Services { get; }

    /// <summary>The name of the reactor.</summary>
    public string Name => _registration.Name;

    /// <summary>
    /// Adds a manager, made by the container when the host starts: its constructor takes services and only records
    /// wiring. It is disposed with the host, if it can be.
    /// </summary>
    /// <typeparam name="TManager">With one public constructor.</typeparam>
    public RabitBuilder AddManager<
        [DynamicallyAccessedMembers(DynamicallyAccessedMemberTypes.PublicConstructors)] TManager>()
        where TManager : RabitManager
    {
        _registration.Managers.Add(new ManagerRegistration(
            typeof(TManager).Name, p => ActivatorUtilities.CreateInstance<TManager>(p), isOurs: true));
        return this;
    }

    /// <summary>
    /// Adds a manager that a function returns when the host starts: one with arguments of its own, or a service of the
    /// container. The host does not dispose it.
    /// </summary>
    /// <param name="create">Called once, on the thread that starts the host.</param>
    public RabitBuilder AddManager(Func<IServiceProvider, RabitManager> create)
    {
        _ = create ?? throw new ArgumentNullException(nameof(create));
        string name = $"manager {_registration.Managers.Count + 1}";
        _registration.Managers.Add(new ManagerRegistration(name, create, isOurs: false));
        return this;
    }

    /// <summary>
    /// Has a function make the reactor, with managers of its own: those that are added here come after them. What the
    /// reactor is made of is disposed by the code that made it.
    /// </summary>
    /// <param name="create">
    /// Called once, on the thread that starts the host, with the options of the host; it passes them on. An
    /// <see cref="Microsoft.Extensions.Options.OptionsValidationException"/> is reported failure by failure.
    /// </param>
    public RabitBuilder CreateReactor(Func<IServiceProvider, ReactorOptions, RabitReactor> create)
    {
        _registration.Create = create ?? throw new ArgumentNullException(nameof(create));
        return this;
    }

    /// <summary>
    /// Puts a text before the status that systemd shows, for example the phase of a mission.
    /// </summary>
    /// <param name="describe">
    /// Called with the reactor once it has started; what it returns is called about once a second, by one thread at a
    /// time, and gives one line, or null for none.
    /// </param>
    public RabitBuilder DescribeStatus(Func<RabitReactor, Func<string?>> describe)
    {
        _registration.Describe = describe ?? throw new ArgumentNullException(nameof(describe));
        return this;
    }

    /// <summary>Sets options in code; what the configuration says comes after it and counts.</summary>
    /// <param name="configure">Called when the host starts.</param>
    public RabitBuilder Configure(Action<RabitHostOptions> configure)
    {
        _registration.Options.Add(configure ?? throw new ArgumentNullException(nameof(configure)));
        return this;
    }

    /// <summary>
    /// Sets what no configuration can hold: the time, hang policies. Log, signals and the limits of the stop are set
    /// before it by the host.
    /// </summary>
    /// <param name="configure">Called when the host starts, before the reactor is made.</param>
    public RabitBuilder ConfigureReactor(Action<IServiceProvider, ReactorOptions> configure)
    {
        _registration.Reactor.Add(configure ?? throw new ArgumentNullException(nameof(configure)));
        return this;
    }

    /// <summary>
    /// Has code outside managers make its endpoints (<see cref="RabitReactor.Workspace"/>): publishers and senders, as
    /// a controller or a page needs them.
    /// </summary>
    /// <param name="setup">Called when the host starts, after the managers were added and before the wiring.</param>
    public RabitBuilder Setup(Action<IServiceProvider, RabitReactor> setup)
    {
        _registration.Setup.Add(setup ?? throw new ArgumentNullException(nameof(setup)));
        return this;
    }
}
