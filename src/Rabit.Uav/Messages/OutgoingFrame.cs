using System;
using Rabit.Mavlink;

namespace Rabit.Uav.Messages;

/// <summary>
/// A frame of ours that is to be sent. Communications gives it its sequence number and finds the links. A plain value.
/// </summary>
public struct OutgoingFrame
{
    /// <summary>The frame, from our own address, with any sequence number.</summary>
    public MavlinkFrame Frame { get; set; }

    /// <summary>
    /// After this time, by the clock of the run, it is not sent any more, and counted as dropped; zero: no limit.
    /// </summary>
    public TimeSpan ValidUntil { get; set; }
}
