using System;
using System.Collections.Generic;
using System.Linq;
using Microsoft.Extensions.Configuration;
using Microsoft.Extensions.Hosting;
using Microsoft.Extensions.Logging;
using Microsoft.Extensions.Options;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>Makes the reactors of a host from what was registered and configured; finds all faults first.</summary>
internal sealed class ReactorFactory(
    IServiceProvider services, IEnumerable<ReactorRegistration> registrations, ILoggerFactory loggers,
    IOptions<HostOptions> host, IConfiguration? configuration)
{
    private readonly List<ReactorRegistration> _registrations = registrations.ToList();
    private readonly TimeSpan _usable = RabitHostOptions.Usable(host.Value.ShutdownTimeout);

    /// <exception cref="RabitHostingException">Settings are wrong, or managers cannot be made.</exception>
    public List<HostedReactor> Make()
    {
        var faults = new List<string>();
        List<RabitHostOptions> options = _registrations.ConvertAll(r => OptionsOf(r, faults));
        if (faults.Count > 0)
            throw new RabitHostingException(faults);

        Exception? first = null;
        var reactors = new List<HostedReactor>();
        for (int i = 0; i < _registrations.Count; i++)
            reactors.Add(Make(_registrations[i], options[i], faults, ref first));
        if (faults.Count == 0)
            return reactors;
        reactors.ForEach(r => r.Dispose());
        throw new RabitHostingException(faults, first);
    }

    private RabitHostOptions OptionsOf(ReactorRegistration registration, List<string> faults)
    {
        var options = new RabitHostOptions();
        registration.Options.ForEach(configure => configure(options));
        string path = registration.Name == RabitServiceCollectionExtensions.DefaultName
            ? "Rabit"
            : "Rabit:" + registration.Name;
        if (configuration is not null)
            OptionsReader.Read(
                configuration.GetSection(path), _registrations.Select(r => r.Name), options, faults);
        faults.AddRange(options.FindFaults(path, _usable));
        return options;
    }

    private HostedReactor Make(
        ReactorRegistration registration, RabitHostOptions options, List<string> faults, ref Exception? first)
    {
        ReactorOptions run = options.ToReactor(registration.Name, _usable);
        run.Log = new ReactorLogger(loggers, registration.Name).Write;
        registration.Reactor.ForEach(configure => configure(services, run));
        var owned = new List<IDisposable>();
        RabitReactor? reactor = null;
        Try(registration.Name + ": the reactor", faults, ref first, () => reactor = registration.Create(services, run));
        if (reactor is null)
            return new HostedReactor(registration.Name, new RabitReactor(), owned);
        foreach (ManagerRegistration manager in registration.Managers)
        {
            Try($"{registration.Name}: {manager.Name}", faults, ref first, () =>
            {
                RabitManager made = manager.Create(services);
                if (manager.IsOurs && made is IDisposable disposable)
                    owned.Add(disposable);
                reactor.Add(made);
            });
        }

        if (faults.Count == 0)
            registration.Setup.ForEach(setup => setup(services, reactor));
        return new HostedReactor(registration.Name, reactor, owned);
    }

    // What goes wrong is reported with all others.
    private static void Try(string what, List<string> faults, ref Exception? first, Action make)
    {
        try
        {
            make();
        }
        catch (OptionsValidationException e)
        {
            faults.AddRange(e.Failures);
            first ??= e;
        }
        catch (Exception e)
        {
            faults.Add($"{what} cannot be made: {e.Message}");
            first ??= e;
        }
    }
}
