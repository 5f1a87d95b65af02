using System;
using System.Threading;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Latency.Signals;

namespace Rabit.Latency.PingPong;

/// <summary>Two threads without Rabit, a signal for each.</summary>
internal sealed class BaselinePingPong : PingPongTarget
{
    private readonly Signal _ping;
    private readonly Signal _pong;
    private readonly int _cpu;
    private readonly Thread _answerer;
    private volatile bool _stopped;

    public BaselinePingPong(Func<Signal> create, int cpu, int answererCpu)
    {
        _ping = create();
        _pong = create();
        _cpu = cpu;
        _answerer = Pinned.Start(answererCpu, "answerer", Answer);
    }

    public override long Play(int roundTrips)
    {
        long took = 0;
        Pinned.Run(_cpu, () =>
        {
            long start = MonotonicClock.Now;
            for (int i = 0; i < roundTrips; i++)
            {
                _ping.Set();
                _pong.Wait();
            }

            took = MonotonicClock.Now - start;
        });
        return took;
    }

    public override void Dispose()
    {
        _stopped = true;
        _ping.Set();
        _answerer.Join();
        _ping.Dispose();
        _pong.Dispose();
    }

    private void Answer()
    {
        while (true)
        {
            _ping.Wait();
            if (_stopped)
                return;
            _pong.Set();
        }
    }
}
