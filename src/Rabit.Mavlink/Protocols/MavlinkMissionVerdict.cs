namespace Rabit.Mavlink;

/// <summary>What became of a mission transfer.</summary>
public enum MavlinkMissionVerdict
{
    /// <summary>Nothing yet; never part of an outcome.</summary>
    None,

    /// <summary>Uploaded, downloaded or cleared.</summary>
    Done,

    /// <summary>The vehicle refused it; the result says why.</summary>
    Refused,

    /// <summary>The tries are spent. Of an upload or a clear: what the vehicle has now is not known.</summary>
    Unanswered,

    /// <summary>The caller, or the vehicle, cancelled it.</summary>
    Cancelled,
}
