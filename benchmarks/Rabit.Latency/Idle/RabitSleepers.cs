using System;
using Rabit.Core;

namespace Rabit.Latency.Idle;

/// <summary>Managers with a fixed period.</summary>
internal sealed class RabitSleepers : Sleepers
{
    private readonly RabitReactor _reactor;

    public RabitSleepers(WaitEngine engine, TimeSpan period, int number = Number)
    {
        _reactor = RabitRun.Create(engine);
        for (int i = 0; i < number; i++)
            _reactor.Add(new Sleeper($"sleeper {i}", period));
        _reactor.Start();
    }

    public override void Dispose() => RabitRun.End(_reactor);

    private sealed class Sleeper : RabitManager
    {
        public Sleeper(string name, TimeSpan period)
            : base(name) => Period = period;

        protected override void ExecuteUnitOfWork()
        {
        }
    }
}
