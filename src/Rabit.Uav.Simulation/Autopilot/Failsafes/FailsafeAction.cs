namespace Rabit.Uav.Simulation;

/// <summary>
/// What ArduCopter's failsafes can do, by the numbers of BATT_FS_LOW_ACT and BATT_FS_CRT_ACT. Here there is no SmartRTL
/// and no landing sequence of a mission: what falls back on RTL or LAND without them does so.
/// </summary>
internal enum FailsafeAction
{
    None = 0,
    Land = 1,
    Return = 2,
    SmartReturnOrReturn = 3,
    SmartReturnOrLand = 4,
    Terminate = 5,
    LandSequenceOrReturn = 6,
    BrakeOrLand = 7,
}
