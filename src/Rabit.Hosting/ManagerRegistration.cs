using System;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>How one manager is made. Immutable.</summary>
internal sealed class ManagerRegistration(string name, Func<IServiceProvider, RabitManager> create, bool isOurs)
{
    /// <summary>For messages, before the manager itself is there with its name.</summary>
    public string Name { get; } = name;

    public Func<IServiceProvider, RabitManager> Create { get; } = create;

    /// <summary>Whether the manager is disposed with the host, because only the host knows of it.</summary>
    public bool IsOurs { get; } = isOurs;
}
