using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// What was seen of the lanes, to and from others. Each vehicle sends all that it knows, also what it received, so that
/// a vehicle that was away learns it from any of them. One thread.
/// </summary>
internal sealed class CoverageExchange
{
    // While something new was seen; all is repeated more slowly, for those that missed it.
    private static readonly TimeSpan ChangedPeriod = TimeSpan.FromSeconds(5);
    private static readonly TimeSpan RepeatPeriod = TimeSpan.FromSeconds(20);

    private int _nextLane;
    private int _nextBlock;
    private int _sentChanges;
    private TimeSpan _sent;

    /// <summary>Coverages that were not of our lanes.</summary>
    public long Refused { get; private set; }

    public void Clear() => (_nextLane, _nextBlock, _sentChanges, _sent) = (0, 0, 0, TimeSpan.Zero);

    public void Receive(in LaneCoverage received, SharedLanes lanes, CoverageGrid coverage)
    {
        if (!lanes.Take(received, coverage))
            Refused++;
    }

    /// <summary>Looks at one lane, and gives what is due to be sent; null where nothing is.</summary>
    /// <param name="lanes">The lanes.</param>
    /// <param name="coverage">What was seen.</param>
    /// <param name="now">The time.</param>
    /// <param name="hasOthers">Whether another vehicle is received.</param>
    public LaneCoverage? Update(SharedLanes lanes, CoverageGrid coverage, TimeSpan now, bool hasOthers)
    {
        int count = lanes.Lanes.Count;
        _nextLane = (_nextLane + 1) % count;
        lanes.Take(_nextLane, coverage);
        bool isDue = now - _sent >= (lanes.Changes != _sentChanges ? ChangedPeriod : RepeatPeriod);
        if (!isDue || !hasOthers || lanes.Changes == 0)
            return null;

        // Of more lanes than one message has, the next ones follow at once.
        int first = _nextBlock * LaneCoverage.MaxLanes;
        bool isLast = first + LaneCoverage.MaxLanes >= count;
        _nextBlock = isLast ? 0 : _nextBlock + 1;
        if (isLast)
            (_sent, _sentChanges) = (now, lanes.Changes);
        return lanes.ToMessage(first);
    }
}
