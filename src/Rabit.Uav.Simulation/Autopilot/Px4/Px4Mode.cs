namespace Rabit.Uav.Simulation;

/// <summary>
/// Flight modes of PX4 that the simulation flies, as the custom mode of the heartbeat has them: the main mode in the
/// third byte, the sub mode in the fourth (px4_custom_mode.h).
/// </summary>
internal enum Px4Mode : uint
{
    Altctl = 0x0002_0000,
    Posctl = 0x0003_0000,
    Orbit = 0x0103_0000,
    Offboard = 0x0006_0000,
    Takeoff = 0x0204_0000,
    Loiter = 0x0304_0000,
    Mission = 0x0404_0000,
    Rtl = 0x0504_0000,
    Land = 0x0604_0000,
}
