using System;
using Rabit.Core;

namespace Rabit.Benchmarks.Core;

/// <summary>Gives a manager one unit of work at a time, on the calling thread, in virtual time.</summary>
internal sealed class VirtualSteps : IDisposable
{
    private readonly RabitManager _manager;
    private readonly RabitReactor _reactor;

    public VirtualSteps(RabitManager manager)
    {
        _manager = manager;
        _reactor = new RabitReactor(new VirtualTime()) { manager };
        _reactor.Start();
        _reactor.RunFor(TimeSpan.FromMilliseconds(1));
    }

    public void Run()
    {
        _manager.WakeUp();
        _reactor.RunFor(TimeSpan.FromMilliseconds(1));
    }

    public void Dispose()
    {
        _reactor.Stop();
        _reactor.Finish();
    }
}
