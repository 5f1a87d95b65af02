using System;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>
/// Estimates how far our clock is ahead of the autopilot's by when its messages come in: the quickest of the last 10 to
/// 20 seconds. Late by the shortest delay of the link, which it cannot see. No I/O, one thread.
/// </summary>
internal sealed class ArrivalFilter
{
    private static readonly TimeSpan Bucket = TimeSpan.FromSeconds(10);

    // No link is that late; the clock is another one, or its 32-bit milliseconds have started again.
    private static readonly TimeSpan Jump = TimeSpan.FromHours(1);

    private TimeSpan? _before;
    private TimeSpan? _current;
    private TimeSpan _bucketEnd;

    /// <summary>Whether anything came.</summary>
    public bool IsKnown => _current is not null;

    /// <summary>Our clock less the autopilot's. Only once something came.</summary>
    public TimeSpan Offset => _before is { } before && before < _current!.Value ? before : _current!.Value;

    /// <summary>Forgets everything.</summary>
    public void Clear()
    {
        _before = null;
        _current = null;
    }

    /// <summary>Takes a message: what the autopilot's clock said in it, and when it came.</summary>
    public void Take(TimeSpan theirs, TimeSpan arrival)
    {
        TimeSpan offset = arrival - theirs;
        if (_current is { } known && (offset - known).Duration() > Jump)
            Clear();
        if (_current is null || arrival >= _bucketEnd)
        {
            // After a pause what was before is too old.
            _before = arrival < _bucketEnd + Bucket ? _current : null;
            _current = offset;
            _bucketEnd = arrival + Bucket;
        }
        else if (offset < _current.Value)
        {
            _current = offset;
        }
    }
}
