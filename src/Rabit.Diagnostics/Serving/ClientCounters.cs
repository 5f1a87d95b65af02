using System.Threading;

namespace Rabit.Diagnostics.Serving;

/// <summary>Counts clients and what became of them; any thread.</summary>
internal sealed class ClientCounters
{
    private int _connected;
    private long _accepted;
    private long _refused;
    private long _refusedRequests;
    private long _dropped;
    private long _skippedSamples;

    public DiagnosticsCounters Read() => new()
    {
        Connected = Volatile.Read(ref _connected),
        Accepted = Interlocked.Read(ref _accepted),
        Refused = Interlocked.Read(ref _refused),
        RefusedRequests = Interlocked.Read(ref _refusedRequests),
        Dropped = Interlocked.Read(ref _dropped),
        SkippedSamples = Interlocked.Read(ref _skippedSamples),
    };

    /// <returns>False where there are as many already, which counts as refused.</returns>
    public bool TryAdd(int max)
    {
        if (Interlocked.Increment(ref _connected) <= max)
        {
            Interlocked.Increment(ref _accepted);
            return true;
        }

        Interlocked.Decrement(ref _connected);
        Refuse();
        return false;
    }

    public void Remove() => Interlocked.Decrement(ref _connected);

    public void Refuse() => Interlocked.Increment(ref _refused);

    public void RefuseRequest() => Interlocked.Increment(ref _refusedRequests);

    public void Drop() => Interlocked.Increment(ref _dropped);

    public void Skip(long samples) => Interlocked.Add(ref _skippedSamples, samples);
}
