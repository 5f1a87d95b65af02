using System;
using System.Collections.Generic;
using System.Threading;

namespace Rabit.Latency.Idle;

/// <summary>Threads without Rabit.</summary>
internal sealed class BaselineSleepers : Sleepers
{
    private readonly List<Thread> _threads = [];
    private readonly List<Action> _wakes = [];
    private volatile bool _stopped;

    /// <param name="make">Makes what one thread sleeps on, and what wakes it.</param>
    /// <param name="number">How many threads.</param>
    public BaselineSleepers(Func<(Action Sleep, Action Wake)> make, int number = Number)
    {
        for (int i = 0; i < number; i++)
        {
            (Action sleep, Action wake) = make();
            _wakes.Add(wake);
            _threads.Add(new Thread(() =>
            {
                while (!_stopped)
                    sleep();
            })
            {
                IsBackground = true,
            });
        }

        _threads.ForEach(t => t.Start());
    }

    /// <summary>Threads that wait for an <see cref="AutoResetEvent"/> of their own.</summary>
    public static BaselineSleepers OnEvents(TimeSpan period, int number = Number) => new(
        () =>
        {
            var signal = new AutoResetEvent(initialState: false);
            return (() => signal.WaitOne(period), () => signal.Set());
        },
        number);

    public override void Dispose()
    {
        _stopped = true;
        _wakes.ForEach(w => w());
        _threads.ForEach(t => t.Join());
    }
}
