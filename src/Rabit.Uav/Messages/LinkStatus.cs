using System;
using Rabit.Mavlink;

namespace Rabit.Uav.Messages;

/// <summary>
/// What Communications reports of one link, at least once a second. A plain value; counts are since the start.
/// </summary>
public struct LinkStatus
{
    /// <summary>How it is.</summary>
    public LinkState State { get; set; }

    /// <summary>The URL it was opened by.</summary>
    public string? Url { get; set; }

    /// <summary>What ended it, where it failed; what keeps it from being open, where it is tried again.</summary>
    public string? Fault { get; set; }

    /// <summary>When the last frame came in, by the clock of the run; null before the first.</summary>
    public TimeSpan? LastFrameTime { get; set; }

    /// <summary>
    /// When the last HEARTBEAT of a ground station (MAV_TYPE_GCS) came in over it; null before the first.
    /// </summary>
    public TimeSpan? GroundStationTime { get; set; }

    /// <summary>Frames that came in.</summary>
    public long FramesIn { get; set; }

    /// <summary>Frames that were sent or forwarded to it.</summary>
    public long FramesOut { get; set; }

    /// <summary>
    /// Frames that never came, by the gaps in the sequence numbers of their senders; late ones are no loss. Counted for
    /// senders whose frames nothing in between may keep: the only one on the link, and the autopilot at the other end
    /// of a wire.
    /// </summary>
    public long FramesMissing { get; set; }

    /// <summary>Bytes that came in and belong to no frame.</summary>
    public long BytesLost { get; set; }

    /// <summary>Frames that came in and had no room in our queues.</summary>
    public long FramesDroppedIn { get; set; }

    /// <summary>
    /// Frames that were to go out and did not: there was no room, no connected receiver, or the link had ended.
    /// </summary>
    public long FramesDroppedOut { get; set; }

    /// <summary>
    /// Frames that had come in a moment before already, over this or another link, or were our own come back: they went
    /// no further.
    /// </summary>
    public long FramesDuplicate { get; set; }

    /// <summary>
    /// Frames with our own address that we did not send, and such with that of our autopilot while that comes in over
    /// another link. The first go nowhere, the others are used.
    /// </summary>
    public long AddressConflicts { get; set; }

    /// <summary>
    /// The results of verifying the signatures of the frames that came in, where the link is signed. Rejected ones
    /// count in <see cref="FramesIn"/>, and go nowhere.
    /// </summary>
    public MavlinkSignatureCounters Signatures { get; set; }

    /// <summary>What it is called; null where it has no name.</summary>
    public string? Name { get; set; }

    /// <summary>Whether it may be silent, or not open, without a warning.</summary>
    public bool IsOptional { get; set; }

    /// <summary>Frames that came in, and that its settings do not let in.</summary>
    public long FramesFilteredIn { get; set; }

    /// <summary>Frames that were to go out, and that its settings do not let out.</summary>
    public long FramesFilteredOut { get; set; }

    /// <summary>How many times it was opened; above 1 where it was away and came back. 0 for a recorded log.</summary>
    public long Openings { get; set; }

    /// <summary>How it sends where it has a budget; all zero where not.</summary>
    public LinkBudgetStatus Budget { get; set; }

    /// <summary>How much of a recorded log has been read, 0 to 1; NaN for a live link.</summary>
    public double Progress { get; set; }
}
