using BenchmarkDotNet.Attributes;

namespace Rabit.Benchmarks.Core;

/// <summary>
/// Messages of 64 bytes from senders to one receiver, each on a thread of its own that sleeps when the queue is full or
/// empty: the time per message until the last one has arrived.
/// </summary>
public class QueueThroughputBenchmarks
{
    private const int Capacity = 1024;
    private const int Messages = 200_000;

    private ThroughputRun _run = null!;

    [Params(1, 2)]
    public int Senders { get; set; }

    [GlobalSetup(Target = nameof(Lock))]
    public void StartLock() => _run = new LockThroughput(Senders, Capacity);

    [GlobalSetup(Target = nameof(Channel))]
    public void StartChannel() => _run = new ChannelThroughput(Senders, Capacity);

    [GlobalSetup(Target = nameof(Rabit))]
    public void StartRabit() => _run = new RabitThroughput(Senders, Capacity);

    [GlobalCleanup]
    public void Stop() => _run.Dispose();

    [Benchmark(Baseline = true, OperationsPerInvoke = Messages)]
    public void Lock() => _run.Transfer(Messages);

    [Benchmark(OperationsPerInvoke = Messages)]
    public void Channel() => _run.Transfer(Messages);

    [Benchmark(OperationsPerInvoke = Messages)]
    public void Rabit() => _run.Transfer(Messages);
}
