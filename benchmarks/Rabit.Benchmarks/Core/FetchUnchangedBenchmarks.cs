using System.Threading;
using BenchmarkDotNet.Attributes;

namespace Rabit.Benchmarks.Core;

/// <summary>
/// Asking for news when there is none: what most fetches of a control loop do. The limit is a volatile read.
/// </summary>
public class FetchUnchangedBenchmarks : MessageBenchmarks
{
    private VehiclePose _copy;
    private long _seen;
    private readonly int[] _version = new int[1];
    private int _news;

    [Benchmark(OperationsPerInvoke = Operations)]
    public void VolatileRead() => InManager(() =>
    {
        ref int version = ref _version[0];
        for (int i = 0; i < Operations; i++)
        {
            if (Volatile.Read(ref version) != 0)
                _news++;
        }
    });

    [Benchmark(Baseline = true, OperationsPerInvoke = Operations)]
    public void Lock() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            if (Locked.Fetch(ref _copy, ref _seen))
                _news++;
        }
    });

    [Benchmark(OperationsPerInvoke = Operations)]
    public void Channel() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            if (LatestValue.Reader.TryRead(out _copy))
                _news++;
        }
    });

    [Benchmark(OperationsPerInvoke = Operations)]
    public void Rabit() => InManager(() =>
    {
        for (int i = 0; i < Operations; i++)
        {
            if (Manager.Quiet.Fetch())
                _news++;
        }
    });
}
