using System;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>A frame on its way to the recording. A plain value.</summary>
internal struct FrameToRecord
{
    public MavlinkFrame Frame;

    /// <summary>When it came in or went out, by the clock of the run.</summary>
    public TimeSpan Time;

    /// <summary>The same by the wall clock, microseconds since 1970 UTC.</summary>
    public long UtcMicroseconds;
}
