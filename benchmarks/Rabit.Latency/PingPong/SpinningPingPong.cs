using System.Threading;
using Rabit.Latency.Measuring;
using Rabit.Latency.Native;

namespace Rabit.Latency.PingPong;

/// <summary>
/// A word for each way, written interlocked and looked at without end: the least that two CPUs take.
/// Its threads live as long as a round, since they take both CPUs.
/// </summary>
internal sealed class SpinningPingPong(int cpu, int answererCpu) : PingPongTarget
{
    private const int Ping = 32;   // 128 bytes from all else
    private const int Pong = 2 * Ping;

    private readonly int[] _words = new int[Pong + Ping];

    public override long Play(int roundTrips)
    {
        long took = 0;
        _words[Ping] = _words[Pong] = 0;
        Thread answerer = Pinned.Start(answererCpu, "answerer", () =>
        {
            for (int i = 1; i <= roundTrips; i++)
            {
                WaitFor(Ping, i);
                Interlocked.Exchange(ref _words[Pong], i);
            }
        });
        Pinned.Run(cpu, () =>
        {
            long start = MonotonicClock.Now;
            for (int i = 1; i <= roundTrips; i++)
            {
                Interlocked.Exchange(ref _words[Ping], i);
                WaitFor(Pong, i);
            }

            took = MonotonicClock.Now - start;
        });
        answerer.Join();
        return took;
    }

    public override void Dispose()
    {
    }

    private void WaitFor(int word, int value)
    {
        while (Volatile.Read(ref _words[word]) != value)
            Thread.SpinWait(1);
    }
}
