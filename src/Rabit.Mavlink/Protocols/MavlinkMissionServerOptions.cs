using System;

namespace Rabit.Mavlink;

/// <summary>
/// What a <see cref="MavlinkMissionServer"/> has, and its times, which are PX4's. Immutable.
/// </summary>
public sealed class MavlinkMissionServerOptions
{
    /// <summary>Whether it has missions; true by default.</summary>
    public bool HasMission { get; init; } = true;

    /// <summary>Whether it has a fence; true by default.</summary>
    public bool HasFence { get; init; } = true;

    /// <summary>Whether it has rally points; true by default.</summary>
    public bool HasRally { get; init; } = true;

    /// <summary>How many items of one type there may be; 1000. More are answered NO_SPACE.</summary>
    public int MaxItems { get; init; } = 1000;

    /// <summary>How long an item is waited for before it is requested again; 0.25 s.</summary>
    public TimeSpan RequestInterval { get; init; } = TimeSpan.OfSeconds(0.25);

    /// <summary>
    /// How long an upload may go without a new item before it is given up, with OPERATION_CANCELLED; 5 s.
    /// </summary>
    public TimeSpan Timeout { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>
    /// Whether an id of the items, which changes with them, is sent with counts and acknowledgements
    /// (<c>opaque_id</c>); true by default.
    /// </summary>
    public bool SendsIds { get; init; } = true;

    /// <summary>
    /// Whether what is for component 0 or system 0, which means all, is handled too; false by default: for an
    /// autopilot.
    /// </summary>
    public bool HandlesBroadcast { get; init; }

    /// <summary>
    /// Whether it does as ArduPilot: requests by MISSION_REQUEST, answers an item with a wrong number by
    /// INVALID_SEQUENCE and one without an upload by ERROR, goes on with the upload after an item that it refused, and
    /// takes item 0 of a mission for home. False by default: requests by MISSION_REQUEST_INT, does not answer such
    /// items, and ends the upload.
    /// </summary>
    public bool BehavesAsArduPilot { get; init; }

    /// <summary>
    /// Whether a complete upload that the rules take waits for <see cref="MavlinkMissionServer.Decide"/>, because it is
    /// judged elsewhere; false by default. Until then its last item is requested again once a second, so that the
    /// station does not give up.
    /// </summary>
    public bool DecidesLater { get; init; }

    /// <summary>How many answers may wait to be sent; 32. What comes on top is dropped and counted.</summary>
    public int Capacity { get; init; } = 32;
}
