using System.Threading;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;
using Rabit.Latency.Signals;

namespace Rabit.Latency.Wake;

/// <summary>A thread written without Rabit.</summary>
internal sealed class BaselineWake : WakeTarget
{
    private readonly Signal _signal;
    private readonly Thread _thread;
    private long _posted;             // written by the poster before it signals
    private volatile bool _stopped;

    public BaselineWake(Signal signal, int cpu)
    {
        _signal = signal;
        _thread = Pinned.Start(cpu, "sleeper", Sleep);
    }

    public override void Post(long now)
    {
        Interlocked.Exchange(ref _posted, now);
        _signal.Set();
    }

    public override void Dispose()
    {
        _stopped = true;
        _signal.Set();
        _thread.Join();
        _signal.Dispose();
    }

    private void Sleep()
    {
        while (true)
        {
            _signal.Wait();
            long now = MonotonicClock.Now;
            if (_stopped)
                return;
            Record(Interlocked.Read(ref _posted), now);
        }
    }
}
