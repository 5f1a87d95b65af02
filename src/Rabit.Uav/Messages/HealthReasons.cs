using System;

namespace Rabit.Uav.Messages;

/// <summary>What is wrong. Several may be.</summary>
[Flags]
public enum HealthReasons
{
    /// <summary>Nothing.</summary>
    None = 0,

    /// <summary>No autopilot was heard yet.</summary>
    NoAutopilot = 1,

    /// <summary>The heartbeat of the autopilot stopped coming.</summary>
    AutopilotLost = 2,

    /// <summary>The battery is low.</summary>
    BatteryLow = 4,

    /// <summary>The battery is nearly empty.</summary>
    BatteryCritical = 8,

    /// <summary>The autopilot itself says that its state is critical or an emergency.</summary>
    AutopilotCritical = 16,

    /// <summary>A link is silent.</summary>
    LinkSilent = 32,

    /// <summary>A link failed or was closed by the other end.</summary>
    LinkDown = 64,

    /// <summary>Frames were dropped for want of room.</summary>
    FramesDropped = 128,

    /// <summary>A manager threw.</summary>
    ManagerFaulted = 256,

    /// <summary>A manager has not begun a unit of work for longer than it should.</summary>
    ManagerStuck = 512,

    /// <summary>The camera gives no pictures, though it should search.</summary>
    CameraSilent = 1024,

    /// <summary>The wind is stronger than it may be, and has been for a while.</summary>
    WindHigh = 2048,

    /// <summary>The watchdog found a manager hanging.</summary>
    ManagerHangs = 4096,
}
