using System;
using Rabit.Core.Messaging;

namespace Rabit.Core.Diagnostics;

/// <summary>Tells by a queue's books what was done to it since the last look.</summary>
internal sealed class WatchedQueue(IMessageQueue queue)
{
    private QueueCounters _seen = queue.Counters;

    /// <returns>False when nothing was done to it; the line is then as it was.</returns>
    public bool TryTellChange(EventLine line, TimeSpan now, string actor)
    {
        QueueCounters before = _seen;
        _seen = queue.Counters;
        if (_seen.Pushed == before.Pushed && _seen.Popped == before.Popped && _seen.Dropped == before.Dropped && _seen.Rejected == before.Rejected)
            return false;

        line.Begin(now, actor).Add("queue ").Add(queue.Name).Add(": ");
        Tell(line, _seen.Pushed - before.Pushed, "pushed, ");
        Tell(line, _seen.Popped - before.Popped, "popped, ");
        Tell(line, _seen.Dropped - before.Dropped, "dropped, ");
        Tell(line, _seen.Rejected - before.Rejected, "rejected, ");
        line.Add("holds ").Add(_seen.Resident);
        return true;
    }

    private static void Tell(EventLine line, long count, string what)
    {
        if (count != 0)
            line.Add(count).Add(" ").Add(what);
    }
}
