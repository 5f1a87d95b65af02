using System;
using Rabit.Core;
using Rabit.Latency.Native;

namespace Rabit.Latency.Wake;

/// <summary>A manager that is woken by the post of a message.</summary>
internal sealed class RabitWake : WakeTarget
{
    private readonly RabitReactor _reactor;
    private readonly MessagePublisher<long> _publisher;

    public RabitWake(WaitEngine engine, int cpu)
    {
        _reactor = RabitRun.Create(engine);
        _publisher = _reactor.Workspace.Publish<long>("posted");
        _reactor.Add(new Sleeper(this, cpu));
        _reactor.Start();
    }

    public override void Post(long now)
    {
        _publisher.Value = now;
        _publisher.Post();
    }

    public override void Dispose() => RabitRun.End(_reactor);

    private sealed class Sleeper : RabitManager
    {
        private readonly RabitWake _wake;
        private readonly int _cpu;
        private readonly MessageSubscriber<long> _posted;

        public Sleeper(RabitWake wake, int cpu)
            : base("sleeper")
        {
            _wake = wake;
            _cpu = cpu;
            _posted = Subscribe<long>("posted", wakeOnPost: true);
            WakeUpDelay = TimeSpan.FromHours(1);
        }

        protected override void Startup() => Cpus.Pin(_cpu);

        protected override void ExecuteUnitOfWork()
        {
            long now = MonotonicClock.Now;
            if (_posted.Fetch())
                _wake.Record(_posted.Value, now);
        }
    }
}
