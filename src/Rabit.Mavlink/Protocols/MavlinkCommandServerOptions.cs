using System;

namespace Rabit.Mavlink;

/// <summary>What a <see cref="MavlinkCommandServer"/> listens to, and its times. Immutable.</summary>
public sealed class MavlinkCommandServerOptions
{
    /// <summary>
    /// Whether commands to component 0 or to system 0, which means all, are handled too; false by default. Only an
    /// autopilot should: what a ground station sends to all is meant for the vehicle.
    /// </summary>
    public bool HandlesBroadcast { get; init; }

    /// <summary>
    /// Whether commands to our component of all systems (system 0) are handled too; false by default. So one ground
    /// station commands the same component of several vehicles at once; what is sent to all components is left alone.
    /// </summary>
    public bool HandlesAllSystems { get; init; }

    /// <summary>
    /// How long after a command was received IN_PROGRESS is sent if it has no result yet, and how long after each
    /// IN_PROGRESS the next one; 0.5 s.
    /// </summary>
    public TimeSpan ProgressInterval { get; init; } = TimeSpan.OfSeconds(0.5);

    /// <summary>
    /// How long after its result, and after the last copy of it, a command that is received again counts as the same,
    /// sent again because the answer was lost; 4 s: QGroundControl sends again after 3 s. Zero: every copy that arrives
    /// after the result is a new command.
    /// </summary>
    public TimeSpan RepeatTime { get; init; } = TimeSpan.FromSeconds(4);

    /// <summary>
    /// The same for copies with a <c>confirmation</c> above 0, which are no new command, and for commands that took
    /// long: after IN_PROGRESS a sender waits longer before it sends again; 15 s. At least <see cref="RepeatTime"/>.
    /// </summary>
    public TimeSpan ConfirmedRepeatTime { get; init; } = TimeSpan.FromSeconds(15);

    /// <summary>
    /// How many commands are at work or remembered at once; 64. Where there are more, those are forgotten first that
    /// were received least recently.
    /// </summary>
    public int Capacity { get; init; } = 64;
}
