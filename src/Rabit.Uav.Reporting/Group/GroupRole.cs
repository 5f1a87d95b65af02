using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.Reporting;

/// <summary>What a vehicle did for its group from a moment on. A plain value.</summary>
public readonly record struct GroupRole
{
    /// <summary>Since when, by the clock of the run.</summary>
    public TimeSpan Time { get; init; }

    /// <summary>Whether it was the one that divided the lanes.</summary>
    public bool DividesLanes { get; init; }

    /// <summary>Its share of the lanes.</summary>
    public LaneShare Share { get; init; }

    /// <summary>MAVLink system id of the finder whose target it was to validate; 0 for none.</summary>
    public byte ValidatedFinder { get; init; }

    /// <summary>The number of that target, of its finder.</summary>
    public ushort ValidatedNumber { get; init; }

    /// <summary>The class of that target.</summary>
    public TargetClassName ValidatedClass { get; init; }

    /// <summary>MAVLink system id of the finder of the target that it was to follow; 0 for none.</summary>
    public byte FollowedFinder { get; init; }

    /// <summary>The number of that target, of its finder.</summary>
    public ushort FollowedNumber { get; init; }

    /// <summary>The class of that target.</summary>
    public TargetClassName FollowedClass { get; init; }
}
