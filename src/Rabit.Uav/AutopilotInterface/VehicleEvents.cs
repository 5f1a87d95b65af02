using System;

namespace Rabit.Uav.AutopilotInterface;

/// <summary>What a frame, or the time that passed, came to.</summary>
[Flags]
internal enum VehicleEvents
{
    None = 0,

    /// <summary>The vehicle state is another than before.</summary>
    Changed = 1,

    /// <summary>The autopilot was received for the first time.</summary>
    Found = 2,

    /// <summary>No heartbeat of the autopilot came for too long.</summary>
    Lost = 4,

    /// <summary>The autopilot was lost, and is received again.</summary>
    FoundAgain = 8,

    /// <summary>The autopilot has rebooted.</summary>
    Rebooted = 16,

    /// <summary>The message of the autopilot held values that cannot be; nothing of it was taken over.</summary>
    Refused = 32,

    /// <summary>The frame is not the autopilot's.</summary>
    OfOther = 64,

    /// <summary>The frame is the heartbeat of an autopilot that is not ours.</summary>
    OtherAutopilot = 128,
}
