using System;

namespace Rabit.Uav;

/// <summary>The managers that a <see cref="UavSystem"/> is made of.</summary>
[Flags]
public enum UavManagers
{
    /// <summary>None of them.</summary>
    None = 0,

    /// <summary><see cref="Uav.Communications.CommunicationsManager"/>: the links.</summary>
    Communications = 1,

    /// <summary>
    /// <see cref="Uav.AutopilotInterface.AutopilotManager"/>: the state of the vehicle, and its commands.
    /// </summary>
    AutopilotInterface = 2,

    /// <summary><see cref="Uav.ImageProcessing.ImageProcessingManager"/>: the pictures.</summary>
    ImageProcessing = 4,

    /// <summary><see cref="Uav.SensorFusion.SensorFusionManager"/>: the tracks.</summary>
    SensorFusion = 8,

    /// <summary><see cref="Uav.MissionControl.MissionControlManager"/>: the mission.</summary>
    MissionControl = 16,

    /// <summary>
    /// <see cref="Uav.HealthMonitoring.HealthManager"/>: watches the others, and writes our heartbeat.
    /// </summary>
    HealthMonitoring = 32,

    /// <summary>All six.</summary>
    All = Communications | AutopilotInterface | ImageProcessing | SensorFusion | MissionControl | HealthMonitoring,
}
