using System;
using Rabit.Core.Queues;

namespace Rabit.Core.Diagnostics;

/// <summary>Writes, from a queue's counters, what was done to it since the last call.</summary>
internal sealed class WatchedQueue(IMessageQueue queue)
{
    private QueueCounters _seen = queue.Counters;

    /// <returns>False when nothing was done to it; the line is then as it was.</returns>
    public bool TryWriteChange(EventLine line, TimeSpan now, string actor)
    {
        QueueCounters before = _seen;
        _seen = queue.Counters;
        if (_seen.Pushed == before.Pushed && _seen.Popped == before.Popped && _seen.Dropped == before.Dropped
            && _seen.Rejected == before.Rejected)
            return false;

        line.Begin(now, actor).Add("queue ").Add(queue.Name).Add(": ");
        WriteCount(line, _seen.Pushed - before.Pushed, "pushed, ");
        WriteCount(line, _seen.Popped - before.Popped, "popped, ");
        WriteCount(line, _seen.Dropped - before.Dropped, "dropped, ");
        WriteCount(line, _seen.Rejected - before.Rejected, "rejected, ");
        line.Add("holds ").Add(_seen.Resident);
        return true;
    }

    private static void WriteCount(EventLine line, long count, string what)
    {
        if (count != 0)
            line.Add(count).Add(" ").Add(what);
    }
}
