using System;
using System.Collections.Generic;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>
/// What was seen of the lanes and what is left out, to and from others. Each vehicle sends all that it knows, also what
/// it received, so that a vehicle that was away learns it from any of them. One thread.
/// </summary>
internal sealed class CoverageExchange
{
    // While something new was seen; all is repeated more slowly, for those that missed it.
    private static readonly TimeSpan ChangedPeriod = TimeSpan.FromSeconds(5);
    private static readonly TimeSpan RepeatPeriod = TimeSpan.FromSeconds(20);

    // What is left out is not to be flown by others meanwhile.
    private static readonly TimeSpan SkippedPeriod = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan SkippedTime = TimeSpan.FromSeconds(5);

    private int _nextLane;
    private int _nextBlock;
    private int _sentChanges;
    private TimeSpan _sent;
    private int _knownSkips;
    private TimeSpan _skipped;

    /// <summary>Coverages that were not of our lanes.</summary>
    public long Refused { get; private set; }

    public void Clear()
        => (_nextLane, _nextBlock, _sentChanges, _sent, _knownSkips) = (0, 0, 0, TimeSpan.Zero, 0);

    /// <returns>What is left out of late.</returns>
    public IReadOnlyList<SkippedLane> Receive(in LaneCoverage received, SharedLanes lanes, CoverageGrid coverage)
    {
        if (!lanes.Take(received, coverage))
            Refused++;
        return lanes.TakeSkipped(received);
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
        if (lanes.Skips != _knownSkips)
            (_knownSkips, _skipped) = (lanes.Skips, now);
        TimeSpan period = lanes.Skips > 0 && now - _skipped < SkippedTime ? SkippedPeriod
            : lanes.Changes != _sentChanges ? ChangedPeriod
            : RepeatPeriod;
        bool isDue = now - _sent >= period;
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
