using System;
using System.Globalization;
using Rabit.Core;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>The state of one link between two evaluations.</summary>
internal sealed class LinkWatch(int number, MessageSubscriber<LinkStatus> status)
{
    private readonly string _number = number.ToString(CultureInfo.InvariantCulture);
    private readonly WindowedIncrease _dropped = new();
    private readonly WindowedIncrease _rejected = new();
    private readonly WindowedIncrease _conflicts = new();
    private long _droppedOut;
    private long _droppedWithoutPeer;

    /// <summary>What its rules keep between two evaluations.</summary>
    public HealthRuleSet<LinkFacts> Rules { get; } = new(HealthRules.OfLinks);

    public int Number => number;

    /// <summary>The URL that it was opened by; null until Communications has reported it.</summary>
    public string? Url => status.Value.Url;

    /// <summary>When a ground station was last received over it; null where none ever was.</summary>
    public TimeSpan? GroundStationTime => status.Value.GroundStationTime;

    public LinkFacts Update(TimeSpan now, TimeSpan monitoredSince, HealthOptions options)
    {
        status.Fetch();
        ref readonly LinkStatus value = ref status.Value;

        // Before its first frame, and once it is silent, a link has no peer that could lose what is sent.
        bool hasNoPeer = value.State is LinkState.Waiting or LinkState.Silent
            || (value.State == LinkState.Opening && value.LastFrameTime is null);
        if (hasNoPeer)
            _droppedWithoutPeer += value.FramesDroppedOut - _droppedOut;
        _droppedOut = value.FramesDroppedOut;
        long dropped = value.FramesDroppedIn + value.FramesDroppedOut - _droppedWithoutPeer;
        bool drops = _dropped.Update(dropped, now, options.RecentWindow);
        bool rejects = _rejected.Update(value.Signatures.Rejected, now, options.RecentWindow);
        bool conflicts = _conflicts.Update(value.AddressConflicts, now, options.RecentWindow);
        return new LinkFacts(
            value.Name ?? value.Url ?? _number, value, dropped, drops, rejects, now - monitoredSince, conflicts);
    }
}
