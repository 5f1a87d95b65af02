using System.Threading;

namespace Rabit.Latency.Contention;

/// <summary>
/// A message without Rabit, the limit: a seqlock over four places that are written in turn. A fetcher copies the latest
/// and checks afterwards whether that place was written meanwhile. One poster; no thread is woken, nothing is checked.
/// </summary>
internal sealed class SeqlockValue<T>(T initial)
    where T : struct
{
    private readonly Place[] _places = [new(), new(), new(), new()];
    private T _fetched = initial;   // the fetcher's
    private int _latest;            // the version; its lowest bits are the place
    private int _seen;              // the fetcher's

    public void Post(in T value)
    {
        int version = _latest + 1;
        Place place = _places[version & (_places.Length - 1)];
        Volatile.Write(ref place.Version, version);
        StoreBarrier();   // the version before the value: a fetcher finds out
        place.Value = value;
        Volatile.Write(ref _latest, version);
    }

    public bool Fetch(out T value)
    {
        int latest = Volatile.Read(ref _latest);
        bool isNews = latest != _seen;
        while (latest != _seen)
        {
            Place place = _places[latest & (_places.Length - 1)];
            _fetched = place.Value;
            LoadBarrier();   // the value before the version
            if (Volatile.Read(ref place.Version) == latest)
                _seen = latest;
            else
                latest = Volatile.Read(ref _latest);
        }

        value = _fetched;
        return isNews;
    }

#if NET10_0_OR_GREATER
    private static void StoreBarrier() => Volatile.WriteBarrier();

    private static void LoadBarrier() => Volatile.ReadBarrier();
#else
    private static void StoreBarrier() => Interlocked.MemoryBarrier();

    private static void LoadBarrier() => Interlocked.MemoryBarrier();
#endif

    private sealed class Place
    {
        public int Version;
        public T Value;
    }
}
