using System;
using System.Threading;
using Rabit.Latency.Measuring;

namespace Rabit.Latency.Periods;

/// <summary>A thread that wants all of a CPU, at the ordinary priority.</summary>
internal sealed class CompetingLoad : IDisposable
{
    private readonly Thread _thread;
    private volatile bool _stopped;

    public CompetingLoad(int cpu) => _thread = Pinned.Start(cpu, "competitor", () =>
    {
        while (!_stopped)
            Thread.SpinWait(1000);
    });

    public void Dispose()
    {
        _stopped = true;
        _thread.Join();
    }
}
