namespace Rabit.Uav.Simulation;

/// <summary>Why a failsafe acts, by PX4's own numbers.</summary>
internal enum Px4Cause
{
    Generic = 0,
    ManualControl = 1,
    GroundStation = 2,
    LowBattery = 3,
    CriticalBattery = 4,
    EmergencyBattery = 5,
}
