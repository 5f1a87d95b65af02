using System.Threading;

namespace Rabit.Latency.Contention;

/// <summary>
/// An immutable object without Rabit, handed over by reference; nothing can be cheaper. The poster has two that take
/// turns.
/// </summary>
internal sealed class SharedReference
{
    private readonly PoseObject[] _values = [new PoseObject(0), new PoseObject(1)];
    private PoseObject? _shared;    // written by the poster, read by the fetcher
    private PoseObject? _fetched;   // the fetcher's
    private int _posts;             // the poster's

    public void Post() => Volatile.Write(ref _shared, _values[_posts++ & 1]);

    public bool Fetch()
    {
        PoseObject? value = Volatile.Read(ref _shared);
        if (ReferenceEquals(value, _fetched))
            return false;
        _fetched = value;
        return true;
    }
}
