namespace Rabit.Mavlink;

/// <summary>How an operation on parameters ended.</summary>
public enum MavlinkParameterStatus
{
    /// <summary>No outcome yet; never part of one.</summary>
    None,

    /// <summary>Listed, read or set.</summary>
    Done,

    /// <summary>The vehicle's parameters have the hash that was given: the list was not read.</summary>
    Unchanged,

    /// <summary>The vehicle refused, or kept another value.</summary>
    Refused,

    /// <summary>
    /// All tries were used up without an answer. There may be no such parameter: many autopilots do not answer then. A
    /// value may have been set all the same.
    /// </summary>
    Unknown,

    /// <summary>Of a list: some are missing, or it changed too often while it was read.</summary>
    Incomplete,

    /// <summary>Cancelled by the caller.</summary>
    Cancelled,
}
