using System.Diagnostics;
using System.Threading;

namespace Rabit.Benchmarks.Core;

/// <summary>
/// The latest value of one poster, hand-written, the limit: a seqlock over a few places that are written in turn. It
/// neither checks who uses it nor wakes a subscriber.
/// </summary>
internal sealed class SeqlockMessage<T>
{
    private const int Places = 4;

    private readonly Place[] _places = [new(), new(), new(), new()];
    private int _latest;   // the version; its lowest bits are the place

    public void Post(in T value, long time)
    {
        int version = _latest + 1;
        Place place = _places[version & (Places - 1)];
        Volatile.Write(ref place.Version, version);
        Volatile.WriteBarrier();   // the version before the value: a reader finds out
        place.Value = value;
        place.Time = time;
        Volatile.Write(ref _latest, version);
    }

    public void PostWithTime(in T value) => Post(value, Stopwatch.GetTimestamp());

    private sealed class Place
    {
        public int Version;
        public long Time;
        public T Value = default!;
    }
}
