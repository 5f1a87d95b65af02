namespace Rabit.Uav.Messages;

/// <summary>
/// What a vehicle says to a <see cref="FollowTask"/> that is open, to the vehicle that decides. A plain value.
/// </summary>
public struct FollowBid
{
    /// <summary>The finder of the task.</summary>
    public byte Finder { get; set; }

    /// <summary>The session of the task.</summary>
    public ushort Session { get; set; }

    /// <summary>The number of the task.</summary>
    public ushort Number { get; set; }

    /// <summary>The decision that it is an answer to.</summary>
    public ushort Decision { get; set; }

    /// <summary>Whether it can follow the target.</summary>
    public bool IsOffered { get; set; }

    /// <summary>After what time it would be there, seconds; up to 18 hours.</summary>
    public double Seconds { get; set; }
}
