using System;
using Rabit.Mavlink;

namespace Rabit.Uav.Messages;

/// <summary>
/// A frame that came in, where from and when. A plain value: it is copied into every queue that it goes to.
/// </summary>
public struct LinkFrame
{
    /// <summary>The frame.</summary>
    public MavlinkFrame Frame { get; set; }

    /// <summary>Number of the link that it came from, from 0.</summary>
    public int Link { get; set; }

    /// <summary>
    /// Whether the dialect of the links knows its message id, so that its checksum was checked and is right.
    /// </summary>
    public bool IsChecked { get; set; }

    /// <summary>The system that it is addressed to; 0 where it is for all of them, or was not checked.</summary>
    public byte TargetSystemId { get; set; }

    /// <summary>The component that it is addressed to; 0 where it is for all of them, or was not checked.</summary>
    public byte TargetComponentId { get; set; }

    /// <summary>Which frame of its link it is, from 0; in a recorded log the number of its record.</summary>
    public long Index { get; set; }

    /// <summary>
    /// When its bytes came in, by the clock of the run; for a recorded log when they had come in, at the pace of the
    /// replay.
    /// </summary>
    public TimeSpan Time { get; set; }

    /// <summary>
    /// When its bytes came in, in microseconds since 1970 UTC; for a recorded log the stamp of its record.
    /// </summary>
    public long UtcMicroseconds { get; set; }

    /// <summary>
    /// Whether a component of a system acts on it, by MAVLink's address rules: it is addressed to it, or to all.
    /// </summary>
    internal readonly bool IsFor(byte systemId, byte componentId)
        => TargetSystemId == 0
        || (TargetSystemId == systemId && (TargetComponentId == 0 || TargetComponentId == componentId));

    /// <summary>Takes over what the reader found out.</summary>
    internal void SetAddress(bool isChecked, in MavlinkMessageInfo message)
    {
        IsChecked = isChecked;
        TargetSystemId = isChecked ? Frame.TargetSystem(message) : (byte)0;
        TargetComponentId = isChecked ? Frame.TargetComponent(message) : (byte)0;
    }
}
