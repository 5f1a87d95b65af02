using System;
using System.Collections.Generic;
using System.Threading;

namespace Rabit.Uav.Web.Serving;

/// <summary>No more than five commands in any second; any thread.</summary>
internal sealed class CommandLimit(TimeProvider time)
{
    private const int MaxInSecond = 5;

    private readonly Lock _gate = new();   // guards the times
    private readonly Queue<long> _times = new();

    public bool TryTake()
    {
        lock (_gate)
        {
            long now = time.GetTimestamp();
            while (_times.TryPeek(out long first) && time.GetElapsedTime(first, now) >= TimeSpan.FromSeconds(1))
                _times.Dequeue();
            if (_times.Count >= MaxInSecond)
                return false;
            _times.Enqueue(now);
            return true;
        }
    }
}
