using System.Threading.Channels;
using BenchmarkDotNet.Attributes;
using Rabit.Latency.Throughput;

namespace Rabit.Benchmarks.Core;

/// <summary>
/// A push and the pop that takes it out, on one thread. Rabit's ends are a manager's and run inside its unit of work.
/// The hand-written ring neither checks who uses it nor wakes a receiver: the limit.
/// </summary>
/// <remarks>
/// What is popped goes to another place than what is pushed comes from, both in memory that the compiler cannot leave
/// out. A loop that pushes what it has just popped measures how long the processor takes from a store of 64 bytes to
/// the load of the same bytes, twice for each message and far longer than the ring itself.
/// </remarks>
[GenericTypeArguments(typeof(int))]
[GenericTypeArguments(typeof(CacheLine))]
public class QueuePushPopBenchmarks<T>
    where T : struct
{
    private const int Capacity = 1024;
    private const int PerInvocation = 10_000;

    private readonly MonitorQueue<T> _locked = new(Capacity);
    private readonly SpscRing<T> _ring = new(Capacity);
    private readonly Channel<T> _channel = Channels.Queue<T>(Capacity);
    private readonly PushPopManager<T> _manager = new(Capacity, PerInvocation);
    private VirtualSteps _steps = null!;
    private T _pushed;
    private T _popped;

    [GlobalSetup]
    public void Start()
    {
        _pushed = new T();
        _steps = new VirtualSteps(_manager);
    }

    [GlobalCleanup]
    public void Stop() => _steps.Dispose();

    [Benchmark(Baseline = true, OperationsPerInvoke = PerInvocation)]
    public int Lock()
    {
        int popped = 0;
        for (int i = 0; i < PerInvocation; i++)
        {
            if (_locked.TryPush(_pushed) && _locked.TryPop(out _popped))
                popped++;
        }

        return popped;
    }

    [Benchmark(OperationsPerInvoke = PerInvocation)]
    public int HandWritten()
    {
        int popped = 0;
        for (int i = 0; i < PerInvocation; i++)
        {
            if (_ring.TryPush(_pushed) && _ring.TryPop(out _popped))
                popped++;
        }

        return popped;
    }

    [Benchmark(OperationsPerInvoke = PerInvocation)]
    public int Channel()
    {
        int popped = 0;
        for (int i = 0; i < PerInvocation; i++)
        {
            if (_channel.Writer.TryWrite(_pushed) && _channel.Reader.TryRead(out _popped))
                popped++;
        }

        return popped;
    }

    [Benchmark(OperationsPerInvoke = PerInvocation)]
    public int Rabit()
    {
        _manager.Popped = 0;
        _steps.Run();
        return _manager.Popped;
    }
}
