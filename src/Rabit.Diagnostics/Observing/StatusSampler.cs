using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Diagnostics.Observing;

/// <summary>
/// Reads statuses, queues and messages for one client, with rates since it last did. One thread only.
/// </summary>
internal sealed class StatusSampler(Func<IReadOnlyList<RabitReactor>> findReactors, TimeProvider clock)
{
    private readonly Dictionary<RabitReactor, ReactorProbe> _probes = [];

    public SampleLine Read() => new() { Reactors = findReactors().Select(r => ProbeOf(r).Read()).ToArray() };

    private ReactorProbe ProbeOf(RabitReactor reactor)
    {
        if (!_probes.TryGetValue(reactor, out ReactorProbe? probe))
            _probes.Add(reactor, probe = new ReactorProbe(reactor, clock));
        return probe;
    }
}
