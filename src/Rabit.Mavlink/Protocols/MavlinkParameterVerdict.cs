namespace Rabit.Mavlink;

/// <summary>What became of an operation on parameters.</summary>
public enum MavlinkParameterVerdict
{
    /// <summary>Nothing yet; never part of an outcome.</summary>
    None,

    /// <summary>Listed, read or set.</summary>
    Done,

    /// <summary>The vehicle's parameters have the hash that was given: the list was not read.</summary>
    Unchanged,

    /// <summary>The vehicle said no, or kept another value.</summary>
    Refused,

    /// <summary>The tries are spent. There may be no such parameter: many autopilots do not say so. What was to be set may have been set.</summary>
    Unanswered,

    /// <summary>Of a list: some are missing, or it changed too often while it was read.</summary>
    Incomplete,

    /// <summary>The caller cancelled it.</summary>
    Cancelled,
}
