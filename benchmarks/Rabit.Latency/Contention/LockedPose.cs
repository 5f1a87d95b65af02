using System.Threading;

namespace Rabit.Latency.Contention;

/// <summary>A message by hand: a lock and a version, which the fetcher reads before it takes the lock.</summary>
internal sealed class LockedPose
{
    private readonly object _gate = new();   // guards _shared; _version is written under it, read by all
    private Pose _shared;
    private Pose _posted;                    // the poster's
    private Pose _fetched;                   // the fetcher's
    private int _version;
    private int _seen;                       // the fetcher's

    public void Post()
    {
        _posted.TimeSeconds++;
        lock (_gate)
        {
            _shared = _posted;
            _version++;
        }
    }

    public bool Fetch()
    {
        if (Volatile.Read(ref _version) == _seen)
            return false;
        lock (_gate)
        {
            _fetched = _shared;
            _seen = _version;
        }

        return _fetched.TimeSeconds > 0;
    }
}
