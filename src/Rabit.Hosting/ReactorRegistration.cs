using System;
using System.Collections.Generic;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>What was said of a reactor before the host is built. Filled by one thread, then read only.</summary>
internal sealed class ReactorRegistration(string name)
{
    public string Name { get; } = name;

    /// <summary>Makes the reactor itself, with managers of its own or none.</summary>
    public Func<IServiceProvider, ReactorOptions, RabitReactor> Create { get; set; }
        = (_, options) => new RabitReactor(options);

    /// <summary>What the status of the service begins with; null for nothing.</summary>
    public Func<RabitReactor, Func<string?>>? Describe { get; set; }

    public List<ManagerRegistration> Managers { get; } = [];

    public List<Action<RabitHostOptions>> Options { get; } = [];

    public List<Action<IServiceProvider, ReactorOptions>> Reactor { get; } = [];

    public List<Action<IServiceProvider, RabitReactor>> Setup { get; } = [];
}
