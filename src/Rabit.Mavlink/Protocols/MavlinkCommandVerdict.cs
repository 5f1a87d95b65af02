namespace Rabit.Mavlink;

/// <summary>What became of a command. Every command gets exactly one of these.</summary>
public enum MavlinkCommandVerdict
{
    /// <summary>Nothing yet; never part of an outcome.</summary>
    None,

    /// <summary>The vehicle accepted it; where it takes long, it has done it.</summary>
    Accepted,

    /// <summary>The vehicle refused it; the result says why.</summary>
    Refused,

    /// <summary>It was cancelled: before it was sent, or by the vehicle, whoever asked for that.</summary>
    Cancelled,

    /// <summary>The tries are spent without a final answer. The vehicle may have done it, or may still do it.</summary>
    Unknown,
}
