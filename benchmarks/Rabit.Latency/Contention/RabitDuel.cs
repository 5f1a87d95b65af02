using System;
using System.Threading;
using Rabit.Core;
using Rabit.Latency.Native;

namespace Rabit.Latency.Contention;

/// <summary>A poster and a fetcher that are managers, each within one unit of work. The poster gives the stamps: the clock is not measured.</summary>
internal sealed class RabitDuel<T> : IDisposable
{
    private readonly RabitReactor _reactor = RabitRun.Create(WaitEngine.Best);
    private readonly Poster _poster;
    private readonly Fetcher _fetcher;

    public RabitDuel(T initial, Action<MessagePublisher<T>> fill)
    {
        _poster = new Poster(initial, fill);
        _fetcher = new Fetcher();
        _reactor.Add(_poster);
        _reactor.Add(_fetcher);
        _reactor.Start();
    }

    public double[] Run(double seconds)
    {
        var duel = new Duel();
        return duel.Run(
            seconds,
            () =>
            {
                _poster.Begin(duel);
                _fetcher.Begin(duel);
            },
            () =>
            {
                _poster.WaitForEnd();
                _fetcher.WaitForEnd();
            });
    }

    public void Dispose()
    {
        RabitRun.End(_reactor);
        _poster.Dispose();
        _fetcher.Dispose();
    }

    private abstract class Side : RabitManager, IDisposable
    {
        private readonly AutoResetEvent _ended = new(initialState: false);
        private readonly int _cpu;
        private Duel? _duel;   // set from outside before the wake; taken by the manager

        protected Side(string name, int cpu)
            : base(name)
        {
            _cpu = cpu;
            WakeUpDelay = TimeSpan.FromHours(1);
        }

        public void Begin(Duel duel)
        {
            Volatile.Write(ref _duel, duel);
            WakeUp();
        }

        public void WaitForEnd() => _ended.WaitOne();

        public void Dispose() => _ended.Dispose();

        protected override void Startup() => Cpus.Pin(_cpu);

        protected override void ExecuteUnitOfWork()
        {
            if (Interlocked.Exchange(ref _duel, null) is not { } duel)
                return;
            Fight(duel);
            _ended.Set();
        }

        protected abstract void Fight(Duel duel);
    }

    private sealed class Poster : Side
    {
        private readonly MessagePublisher<T> _message;
        private readonly Action<MessagePublisher<T>> _fill;
        private long _time;

        public Poster(T initial, Action<MessagePublisher<T>> fill)
            : base("poster", Cpus.One)
        {
            _message = Publish("pose", initial);
            _fill = fill;
        }

        protected override void Fight(Duel duel) => duel.Post(() =>
        {
            _fill(_message);
            _message.Post(new TimeSpan(++_time));
        });
    }

    private sealed class Fetcher : Side
    {
        private readonly MessageSubscriber<T> _message;

        public Fetcher()
            : base("fetcher", Cpus.Other) => _message = Subscribe<T>("pose");

        protected override void Fight(Duel duel) => duel.Fetch(() => _message.Fetch());
    }
}
