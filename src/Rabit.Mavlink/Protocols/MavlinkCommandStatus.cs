namespace Rabit.Mavlink;

/// <summary>How a command ended. Every command ends with exactly one of these.</summary>
public enum MavlinkCommandStatus
{
    /// <summary>No outcome yet; never part of one.</summary>
    None,

    /// <summary>The vehicle accepted it; of a command that takes long, it has completed it.</summary>
    Accepted,

    /// <summary>The vehicle refused it; <see cref="MavlinkCommandOutcome.Result"/> says why.</summary>
    Refused,

    /// <summary>Cancelled before it was sent, or by the vehicle, at any sender's request.</summary>
    Cancelled,

    /// <summary>
    /// All tries were used up without a final answer. The vehicle may have executed it, or may still do so.
    /// </summary>
    Unknown,
}
