using System.Threading.Channels;
using BenchmarkDotNet.Attributes;
using Rabit.Latency.Throughput;

namespace Rabit.Benchmarks.Core;

/// <summary>
/// A push and the pop that takes it out, on one thread. Rabit's ends are a manager's and run inside its unit of work.
/// The hand-written ring neither checks who uses it nor wakes a receiver: the limit.
/// </summary>
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

    [GlobalSetup]
    public void Start() => _steps = new VirtualSteps(_manager);

    [GlobalCleanup]
    public void Stop() => _steps.Dispose();

    [Benchmark(Baseline = true, OperationsPerInvoke = PerInvocation)]
    public int Lock()
    {
        int popped = 0;
        T value = default;
        for (int i = 0; i < PerInvocation; i++)
        {
            if (_locked.TryPush(value) && _locked.TryPop(out value))
                popped++;
        }

        return popped;
    }

    [Benchmark(OperationsPerInvoke = PerInvocation)]
    public int HandWritten()
    {
        int popped = 0;
        T value = default;
        for (int i = 0; i < PerInvocation; i++)
        {
            if (_ring.TryPush(value) && _ring.TryPop(out value))
                popped++;
        }

        return popped;
    }

    [Benchmark(OperationsPerInvoke = PerInvocation)]
    public int Channel()
    {
        int popped = 0;
        T value = default;
        for (int i = 0; i < PerInvocation; i++)
        {
            if (_channel.Writer.TryWrite(value) && _channel.Reader.TryRead(out value))
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
