using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>What the rules judge a link by.</summary>
internal readonly struct LinkFacts(string name, in LinkStatus status, long framesDropped, bool hasDroppedLately, TimeSpan watchedFor)
{
    /// <summary>Its URL; its number until Communications has told it.</summary>
    public string Name { get; } = name;

    public LinkState State { get; } = status.State;

    /// <summary>Whether it is a recorded log, which may end.</summary>
    public bool IsRecorded { get; } = !double.IsNaN(status.Progress);

    /// <summary>Frames for which there was no room, either way, since somebody was heard on the link.</summary>
    public long FramesDropped { get; } = framesDropped;

    public bool HasDroppedLately { get; } = hasDroppedLately;

    /// <summary>Since Health Monitoring began.</summary>
    public TimeSpan WatchedFor { get; } = watchedFor;
}
