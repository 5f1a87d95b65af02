using System;
using Rabit.Mavlink;

namespace Rabit.Uav.Communications;

/// <summary>A frame that waits for its turn on a link. A plain value.</summary>
internal struct FrameToSend
{
    public MavlinkFrame Frame;

    /// <summary>Our own: numbered and signed when it goes out.</summary>
    public bool IsOwn;

    public byte CrcExtra;

    /// <summary>It is the one of its copies for several links that is recorded.</summary>
    public bool IsToBeRecorded;

    /// <summary>When it is too old to be sent.</summary>
    public TimeSpan ValidUntil;
}
