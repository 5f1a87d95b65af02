using System;

namespace Rabit.Mavlink;

/// <summary>What a <see cref="MavlinkParameterServer"/> answers, and how. Immutable.</summary>
public sealed class MavlinkParameterServerOptions
{
    /// <summary>
    /// Whether reads and sets for component 0 or system 0, which means all, are handled too; false by default: for an
    /// autopilot.
    /// </summary>
    public bool HandlesBroadcast { get; init; }

    /// <summary>
    /// Whether a list is also sent where all components of our system were asked; true by default: so QGroundControl
    /// asks.
    /// </summary>
    public bool ListsForAll { get; init; } = true;

    /// <summary>
    /// The time between the values of a list; 20 ms, which leaves a slow radio room for other things.
    /// </summary>
    public TimeSpan ListInterval { get; init; } = TimeSpan.OfSeconds(0.02);

    /// <summary>Whether refusals and unknown names are answered by PARAM_ERROR; true by default.</summary>
    public bool SendsErrors { get; init; } = true;

    /// <summary>Whether the reason of a refusal is sent as STATUSTEXT too; true by default.</summary>
    public bool SendsReasons { get; init; } = true;

    /// <summary>
    /// Whether the hash of all values is sent in front of a list as _HASH_CHECK, and a list that is answered by the
    /// same hash stopped, as PX4 does; false by default. See <see cref="MavlinkParameterHash"/>.
    /// </summary>
    public bool SendsHash { get; init; }

    /// <summary>
    /// Which names are left out of the hash; null for <see cref="MavlinkParameterHash.IsVolatile"/>.
    /// </summary>
    public Predicate<string>? IsVolatile { get; init; }

    /// <summary>
    /// Whether a value that was requested by name, or set, is sent with index 65535, as ArduPilot does; false by
    /// default.
    /// </summary>
    public bool OmitsIndex { get; init; }

    /// <summary>How many answers may wait to be sent; 64. What comes on top is dropped and counted.</summary>
    public int Capacity { get; init; } = 64;
}
