using System;
using Rabit.Mavlink;

namespace Rabit.Uav.Messages;

/// <summary>A frame that came in, where from and when. A plain value: it is copied into every queue that it goes to.</summary>
public struct LinkFrame
{
    /// <summary>The frame.</summary>
    public MavlinkFrame Frame { get; set; }

    /// <summary>Number of the link that it came from, from 0.</summary>
    public int Link { get; set; }

    /// <summary>Which frame of its link it is, from 0; in a recorded log the number of its record.</summary>
    public long Index { get; set; }

    /// <summary>When its bytes came in, by the clock of the run; for a recorded log when they had come in, at the pace of the replay.</summary>
    public TimeSpan Time { get; set; }

    /// <summary>When its bytes came in, in microseconds since 1970 UTC; for a recorded log the stamp of its record.</summary>
    public long UtcMicroseconds { get; set; }
}
