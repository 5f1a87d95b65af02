using System;
using Rabit.Geodesy;

namespace Rabit.Uav.Messages;

/// <summary>
/// A target that moves and that one vehicle of a group follows: the state of the task, which the vehicle that decides
/// on it, or follows, repeats, so that a message that is lost or comes twice changes nothing. A plain value.
/// </summary>
public struct FollowTask
{
    /// <summary>MAVLink system id of the vehicle that announced it.</summary>
    public byte Finder { get; set; }

    /// <summary>The run of the finder: after a restart its numbers begin at 1 again.</summary>
    public ushort Session { get; set; }

    /// <summary>The number of the task, of its finder.</summary>
    public ushort Number { get; set; }

    /// <summary>
    /// Grows with each decision on the task. Of two decisions with the same number that of the lower
    /// <see cref="Decider"/> holds.
    /// </summary>
    public ushort Decision { get; set; }

    /// <summary>MAVLink system id of the vehicle that took the decision.</summary>
    public byte Decider { get; set; }

    /// <summary>How far it is.</summary>
    public FollowState State { get; set; }

    /// <summary>MAVLink system id of the vehicle that follows it; 0 for none.</summary>
    public byte Follower { get; set; }

    /// <summary>What that vehicle does, by what it says.</summary>
    public FollowProgress Progress { get; set; }

    /// <summary>How it ended, once it is closed.</summary>
    public FollowResult Result { get; set; }

    /// <summary>The class of the target.</summary>
    public TargetClassName Class { get; set; }

    /// <summary>The id of the printed marker that it is; null for what is none.</summary>
    public int? MarkerId { get; set; }

    /// <summary>Where it was at <see cref="Time"/>; the altitude is not used.</summary>
    public GeodeticPosition Position { get; set; }

    /// <summary>Its velocity then, metres per second; down is 0.</summary>
    public NedVector VelocityNed { get; set; }

    /// <summary>How uncertain the position is: within so many metres with 95 %.</summary>
    public double RadiusMetres { get; set; }

    /// <summary>When it was seen last, by the clock of the run here.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>How long it was in view of those that followed it; in whole seconds between vehicles.</summary>
    public TimeSpan InView { get; set; }
}
