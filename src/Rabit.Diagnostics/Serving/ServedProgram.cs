using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Threading;
using Rabit.Core;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Diagnostics.Serving;

/// <summary>What clients look into. Any thread.</summary>
internal sealed class ServedProgram(string name, IEnumerable<RabitReactor> reactors, TimeProvider clock)
{
    private readonly Lock _lock = new();
    private RabitReactor[] _reactors = reactors.Distinct().ToArray();   // replaced whole under _lock

    public TimeProvider Clock { get; } = clock;

    public IReadOnlyList<RabitReactor> Reactors => Volatile.Read(ref _reactors);

    public HelloLine Hello => new()
    {
        Program = name,
        ProcessId = Environment.ProcessId,
        Version = typeof(RabitDiagnostics).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()
            ?.InformationalVersion.Split('+')[0] ?? string.Empty,
        Reactors = Reactors.Select(r => r.Name).ToArray(),
    };

    public void Add(RabitReactor reactor)
    {
        lock (_lock)
        {
            if (!_reactors.Contains(reactor))
                Volatile.Write(ref _reactors, [.. _reactors, reactor]);
        }
    }

    /// <param name="reactorName">Null for all.</param>
    /// <exception cref="RefusedRequestException">There is none of that name.</exception>
    public IReadOnlyList<RabitReactor> Find(string? reactorName)
    {
        IReadOnlyList<RabitReactor> all = Reactors;
        if (reactorName is null)
            return all;
        RabitReactor[] found = all.Where(r => string.Equals(r.Name, reactorName, StringComparison.Ordinal)).ToArray();
        return found.Length > 0
            ? found
            : throw new RefusedRequestException(
                $"There is no reactor '{reactorName}'; there are: {string.Join(", ", all.Select(r => r.Name))}.");
    }
}
