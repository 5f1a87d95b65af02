using System;
using Rabit.Core;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;

namespace Rabit.Latency.Contention;

/// <summary>
/// A poster and a fetcher that are managers, each within one unit of work. The poster gives the stamps: the clock is
/// not measured.
/// </summary>
internal sealed class RabitContention<T> : IDisposable
{
    private readonly RabitReactor _reactor = RabitRun.Create(WaitEngine.Best);
    private readonly Poster _poster;
    private readonly Fetcher _fetcher;

    public RabitContention(T initial, Action<MessagePublisher<T>> fill)
    {
        _poster = new Poster(initial, fill);
        _fetcher = new Fetcher();
        _reactor.Add(_poster);
        _reactor.Add(_fetcher);
        _reactor.Start();
    }

    public double[] Run(double seconds)
    {
        var contention = new ContentionRun();
        return contention.Run(
            seconds,
            () =>
            {
                _poster.Begin(contention);
                _fetcher.Begin(contention);
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

    private sealed class Poster : FlatOutManager<ContentionRun>
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

        protected override void Work(ContentionRun contention) => contention.Post(() =>
        {
            _fill(_message);
            _message.PostStamped(new TimeSpan(++_time));
        });
    }

    private sealed class Fetcher : FlatOutManager<ContentionRun>
    {
        private readonly MessageSubscriber<T> _message;

        public Fetcher()
            : base("fetcher", Cpus.Other) => _message = Subscribe<T>("pose");

        protected override void Work(ContentionRun contention) => contention.Fetch(() => _message.Fetch());
    }
}
