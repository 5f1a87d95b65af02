using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

/// <summary>Input of the rules for a link.</summary>
internal readonly struct LinkFacts(
    string name, in LinkStatus status, long framesDropped, bool hasDroppedRecently, bool hasRejectedRecently,
    TimeSpan monitoredFor, bool hasConflictedRecently = false)
{
    /// <summary>Its URL; its number until Communications has reported it.</summary>
    public string Name { get; } = name;

    public LinkState State { get; } = status.State;

    /// <summary>Whether it may be silent, or not open.</summary>
    public bool IsOptional { get; } = status.IsOptional;

    /// <summary>Whether it is a recorded log, which may end.</summary>
    public bool IsRecorded { get; } = !double.IsNaN(status.Progress);

    /// <summary>Frames dropped for want of room in either direction while the link had a peer.</summary>
    public long FramesDropped { get; } = framesDropped;

    public bool HasDroppedRecently { get; } = hasDroppedRecently;

    /// <summary>Frames whose signatures were rejected, since the start.</summary>
    public long SignaturesRejected { get; } = status.Signatures.Rejected;

    public bool HasRejectedRecently { get; } = hasRejectedRecently;

    /// <summary>See <see cref="LinkStatus.AddressConflicts"/>.</summary>
    public long AddressConflicts { get; } = status.AddressConflicts;

    public bool HasConflictedRecently { get; } = hasConflictedRecently;

    /// <summary>Since Health Monitoring started.</summary>
    public TimeSpan MonitoredFor { get; } = monitoredFor;
}
