using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>The reactors of a host, a service of it: for code outside managers. Any thread.</summary>
public sealed class HostedReactors
{
    private readonly object _gate = new();
    private readonly List<string> _names;
    private readonly List<ReactorRegistration> _registrations;
    private readonly Dictionary<string, HostedReactor> _reactors = new(StringComparer.Ordinal);   // under _gate

    internal HostedReactors(IEnumerable<ReactorRegistration> registrations)
    {
        _registrations = registrations.ToList();
        _names = _registrations.ConvertAll(r => r.Name);
    }

    /// <summary>Their names, in the order of their start.</summary>
    public IReadOnlyList<string> Names => _names;

    /// <summary>A reactor of the host.</summary>
    /// <param name="name">The one it was added by.</param>
    /// <exception cref="InvalidOperationException">There is none of that name, or the host has not begun to start it.
    /// </exception>
    public RabitReactor this[string name] => Find(name)?.Reactor
        ?? throw new InvalidOperationException(
            _names.Contains(name)
                ? $"The host has not begun to start reactor '{name}'."
                : $"There is no reactor '{name}'; there are: {string.Join(", ", _names)}.");

    /// <summary>How a reactor ended.</summary>
    /// <param name="name">The one it was added by.</param>
    /// <returns>Null while it runs, and before.</returns>
    public ReactorResult? ResultOf(string name) => Find(name)?.Result;

    internal HostedReactor? Find(string name)
    {
        lock (_gate)
            return _reactors.TryGetValue(name, out HostedReactor? reactor) ? reactor : null;
    }

    internal Func<RabitReactor, Func<string?>>? DescriptionOf(string name)
        => _registrations.Find(r => string.Equals(r.Name, name, StringComparison.Ordinal))?.Describe;

    internal void Add(HostedReactor reactor)
    {
        lock (_gate)
            _reactors.Add(reactor.Name, reactor);
    }
}
