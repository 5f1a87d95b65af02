using System;
using System.Collections.Generic;
using System.Linq;
using Rabit.Core;
using Rabit.Diagnostics.Protocol;

namespace Rabit.Diagnostics.Observing;

/// <summary>Reads one reactor from outside its managers. One thread only.</summary>
internal sealed class ReactorProbe(RabitReactor reactor, TimeProvider clock)
{
    private ManagerProbe[]? _managers;   // once it is wired
    private QueueProbe[] _queues = [];
    private MessageProbe[] _messages = [];
    private TimeSpan _lastRunTime;
    private long _lastRead;

    public ReactorFigures Read()
    {
        if (!reactor.IsWired)
            return new ReactorFigures { Name = reactor.Name, TimeSeconds = reactor.Now.TotalSeconds };
        bool isFirst = _managers is null;
        IReadOnlyList<ManagerProbe> managers = _managers ?? Attach();
        TimeSpan now = reactor.Now;
        long read = clock.GetTimestamp();
        Elapsed? elapsed = isFirst ? null : new Elapsed(now - _lastRunTime, clock.GetElapsedTime(_lastRead, read));
        (_lastRunTime, _lastRead) = (now, read);
        return new ReactorFigures
        {
            Name = reactor.Name,
            IsStarted = true,
            TimeSeconds = now.TotalSeconds,
            Speed = elapsed?.Speed,
            Managers = managers.Select(m => m.Read(elapsed)).ToArray(),
            Queues = Array.ConvertAll(_queues, q => q.Read(elapsed)),
            Messages = Array.ConvertAll(_messages, m => m.Read(elapsed, now)),
        };
    }

    private ManagerProbe[] Attach()
    {
        _queues = reactor.Workspace.ObserveQueues().Select(q => new QueueProbe(q)).ToArray();
        _messages = reactor.Workspace.ObserveMessages().Where(m => m.ValueType != typeof(ManagerStatus))
            .Select(m => new MessageProbe(m)).ToArray();
        return _managers = reactor.Select(m => new ManagerProbe(reactor, m.Name)).ToArray();
    }
}
