namespace Rabit.Mavlink;

/// <summary>How a mission transfer ended.</summary>
public enum MavlinkMissionStatus
{
    /// <summary>No outcome yet; never part of one.</summary>
    None,

    /// <summary>Uploaded, downloaded or cleared.</summary>
    Done,

    /// <summary>The vehicle refused it; <see cref="MavlinkMissionOutcome.Result"/> says why.</summary>
    Refused,

    /// <summary>
    /// All tries were used up without a final answer. Of an upload or a clear: what the vehicle has now is not known.
    /// </summary>
    Unknown,

    /// <summary>Cancelled by the caller or by the vehicle.</summary>
    Cancelled,
}
