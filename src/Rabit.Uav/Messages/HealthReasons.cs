using System;

namespace Rabit.Uav.Messages;

/// <summary>What is wrong; several reasons can hold at a time.</summary>
[Flags]
public enum HealthReasons : long
{
    /// <summary>Nothing.</summary>
    None = 0,

    /// <summary>No autopilot was detected yet.</summary>
    NoAutopilot = 1,

    /// <summary>The heartbeats of the autopilot stopped.</summary>
    AutopilotLost = 2,

    /// <summary>The battery is low.</summary>
    BatteryLow = 4,

    /// <summary>The battery is nearly empty.</summary>
    BatteryCritical = 8,

    /// <summary>The autopilot reports that its state is critical or an emergency.</summary>
    AutopilotCritical = 16,

    /// <summary>A link is silent.</summary>
    LinkSilent = 32,

    /// <summary>A link failed or was closed by the other end.</summary>
    LinkDown = 64,

    /// <summary>Frames were dropped because a queue was full.</summary>
    FramesDropped = 128,

    /// <summary>A manager threw.</summary>
    ManagerFaulted = 256,

    /// <summary>A manager has not begun a unit of work for longer than it should.</summary>
    ManagerStuck = 512,

    /// <summary>The camera delivers no pictures during a search.</summary>
    CameraSilent = 1024,

    /// <summary>The wind has been above its limit for some time.</summary>
    WindHigh = 2048,

    /// <summary>The watchdog detected a manager that hangs.</summary>
    ManagerHangs = 4096,

    /// <summary>
    /// The target detector threw, gave detections that are not valid, or took longer than its time budget.
    /// </summary>
    DetectorFault = 8192,

    /// <summary>Frames on a signed link are rejected: another key, or none, or not in time.</summary>
    SignaturesRejected = 16384,

    /// <summary>The autopilot is received and answers no command.</summary>
    CommandsUnanswered = 32768,

    /// <summary>The satellite fix is lost, or has few satellites or a poor geometry.</summary>
    PositionFixPoor = 65536,

    /// <summary>
    /// The autopilot reports no position, or one that stands still while the vehicle flies, or that jumped.
    /// </summary>
    PositionInvalid = 131072,

    /// <summary>The estimator of the autopilot contradicts its sensors, or has no position.</summary>
    EstimatorUnhealthy = 262144,

    /// <summary>The height disagrees with the air pressure.</summary>
    HeightInconsistent = 524288,

    /// <summary>The charge of the battery is not known.</summary>
    BatteryUnknown = 1048576,

    /// <summary>The heartbeats of the ground station stopped.</summary>
    GroundStationLost = 2097152,

    /// <summary>The companion computer is hot.</summary>
    ComputerHot = 4194304,

    /// <summary>The companion computer has too little voltage, or lowers its clock.</summary>
    ComputerThrottled = 8388608,

    /// <summary>Most of the memory of the companion computer is in use.</summary>
    MemoryLow = 16777216,

    /// <summary>The disk of the companion computer is nearly full.</summary>
    DiskLow = 33554432,

    /// <summary>
    /// Too few of the pictures of a search can be used; <see cref="ImagingStatus.UnusableCause"/> says why.
    /// </summary>
    PicturesUnusable = 67108864,

    /// <summary>What is left in the battery is needed for the way home.</summary>
    EnergyLow = 536870912,

    /// <summary>What is left in the battery does not reach home, and is needed to land.</summary>
    HomeOutOfReach = 1073741824,

    /// <summary>
    /// The times of pictures and poses do not match, by what the reports of the same targets show, or may not, because
    /// the link takes long.
    /// </summary>
    CameraClockOffset = 134217728,

    /// <summary>Many targets are not seen again where they were: a symptom of wrong times or a wrong mount.</summary>
    TargetsNotConfirmed = 268435456,

    /// <summary>
    /// Frames come in that have our own address and are not from us, or that of our autopilot over another link.
    /// </summary>
    AddressConflict = 2147483648,

    /// <summary>Frames are missing in the recording of the links.</summary>
    RecordingIncomplete = 4294967296,
}
