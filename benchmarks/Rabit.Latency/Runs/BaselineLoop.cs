using System;
using System.Threading;

namespace Rabit.Latency.Runs;

/// <summary>
/// What a run costs without Rabit and without statistics: a flag that is set and taken, the clock read before and after
/// the work, the running owner marked on the thread.
/// </summary>
internal sealed class BaselineLoop
{
    [ThreadStatic]
    private static object? _running;

    private int _flag;       // set by wakers, taken by the loop
    private TimeSpan _end;
    private long _left;

    /// <summary>When the last run began and ended: read by the measurement.</summary>
    public TimeSpan Took { get; private set; }

    public void Run(long runs)
    {
        _left = runs;
        Wake();
        while (Volatile.Read(ref _flag) != 0)
        {
            Interlocked.Exchange(ref _flag, 0);
            TimeSpan begin = Now();
            object? outer = _running;
            _running = this;
            try
            {
                Work();
            }
            finally
            {
                _running = outer;
            }

            _end = Now();
            Took = _end - begin;
        }
    }

    private void Work()
    {
        if (--_left > 0)
            Wake();
    }

    private void Wake() => Interlocked.CompareExchange(ref _flag, 1, 0);

    private static TimeSpan Now() => new(TimeProvider.System.GetTimestamp() / 100);
}
