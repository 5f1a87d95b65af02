using System;
using System.Collections.Generic;
using System.Threading.Tasks;
using Rabit.Core;

namespace Rabit.Hosting;

/// <summary>
/// Looks at the status of all managers of a reactor, again and again. Missed deadlines are those since the last look.
/// One thread at a time.
/// </summary>
internal sealed class ReactorWatch(HostedReactors reactors, string name)
{
    private readonly List<ManagerStatusWatch> _managers = [];
    private Func<string?>? _describe;

    /// <summary>What there is to see now.</summary>
    public ReactorLook Look()
    {
        var look = new ReactorLook();
        HostedReactor? reactor = reactors.Find(name);
        if (reactor?.Ended.IsCompleted == true)
        {
            string reason = reactor.Result?.StopReason ?? "it did not start";
            look.Add(ReactorCondition.NotRunning, $"{name} has ended: {reason}");
            return look;
        }

        if (reactor?.Started.Status is not TaskStatus.RanToCompletion)
        {
            look.Add(ReactorCondition.NotRunning, $"{name} has not started");
            return look;
        }

        if (_managers.Count == 0)
        {
            foreach (RabitManager manager in reactor.Reactor)
                _managers.Add(new ManagerStatusWatch(manager.Name, reactor.Reactor.Workspace));
            _describe = reactors.DescriptionOf(name)?.Invoke(reactor.Reactor);
        }

        _managers.ForEach(m => m.Look(look));
        look.Description = _describe?.Invoke();
        return look;
    }
}
