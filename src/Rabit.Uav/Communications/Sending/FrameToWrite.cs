using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>A frame that a link is to write. A plain value.</summary>
internal struct FrameToWrite
{
    public MavlinkFrame Frame;

    /// <summary>What comes next goes out in the same write.</summary>
    public bool HasMore;
}
