using Rabit.Mavlink;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>One step of carrying out a vehicle command. A plain value.</summary>
internal struct CommandStep
{
    /// <summary>
    /// What is sent, and acknowledged; the addressee is filled in then. Not of a step that
    /// <see cref="StartsVelocity"/>.
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

    /// <summary>Whether it starts the stream of velocities, which have no acknowledgement.</summary>
    public bool StartsVelocity { get; set; }
}
