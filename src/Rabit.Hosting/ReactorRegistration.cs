using System;
using System.Collections.Generic;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>What was said of a reactor before the host is built. Filled by one thread, then read only.</summary>
internal sealed class ReactorRegistration(string name)
{
    public string Name { get; } = name;

    public List<ManagerRegistration> Managers { get; } = [];

    public List<Action<RabitHostOptions>> Options { get; } = [];

    public List<Action<IServiceProvider, ReactorOptions>> Reactor { get; } = [];

    public List<Action<IServiceProvider, RabitReactor>> Setup { get; } = [];
}
