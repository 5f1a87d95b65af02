using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>One vehicle of a group, as another one of it knows it. A plain value.</summary>
public readonly record struct GroupMember
{
    /// <summary>Its MAVLink system id.</summary>
    public byte SystemId { get; init; }

    /// <summary>Whether it can search.</summary>
    public GroupMemberState State { get; init; }

    /// <summary>Whether it is received; otherwise what is here is what it reported last.</summary>
    public bool IsPresent { get; init; }

    /// <summary>
    /// Whether a second vehicle reports with its system id: that one is left out, and what is here is of the first.
    /// </summary>
    public bool IsTwice { get; init; }

    /// <summary>When its last report was sent, by the clock of the run here.</summary>
    public TimeSpan Time { get; init; }

    /// <summary>Where it was then.</summary>
    public GeodeticPosition Position { get; init; }

    /// <summary>How many lanes it has, flown ones included; 0 where it has none.</summary>
    public int Lanes { get; init; }

    /// <summary>What it has left of them, metres.</summary>
    public double MetresLeft { get; init; }
}
