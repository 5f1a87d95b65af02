using Rabit.Mavlink;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>One step of carrying out a vehicle command. A plain value.</summary>
internal struct CommandStep
{
    /// <summary>
    /// What is sent, and acknowledged; the addressee is filled in then. Not of a step that concerns a stream.
    /// </summary>
    public MavlinkCommand Request { get; set; }

    /// <summary>The mode that the autopilot takes by it; null where it takes none.</summary>
    public uint? Mode { get; set; }

    /// <summary>Whether the step is done only when a heartbeat shows the mode.</summary>
    public bool IsModeAwaited { get; set; }

    /// <summary>
    /// Whether a refusal means nothing once the vehicle has left the ground: it is the answer to a repetition.
    /// </summary>
    public bool IsDoneInTheAir { get; set; }

    /// <summary>
    /// Whether it is sent only on the arrival of a report that shows our mode: what changes the mode, and what would
    /// act in the pilot's.
    /// </summary>
    public bool NeedsReport { get; set; }

    /// <summary>The mode outside which it is not sent; null where it takes the mode itself, or needs none.</summary>
    public uint? OnlyInMode { get; set; }

    /// <summary>Whether it starts the stream of velocities, which have no acknowledgement.</summary>
    public bool StartsVelocity { get; set; }

    /// <summary>Whether it starts the stream of set-points that OFFBOARD needs.</summary>
    public bool StartsStream { get; set; }

    /// <summary>Whether it gives the stream its target.</summary>
    public bool SetsTarget { get; set; }
}
